// The radio dock: links between the robots' radios, on the map, too, and notices when one is lost.
#pragma once

#include <map>
#include <utility>

#include <QObject>

#include "app/desks/desk.h"
#include "core/mission/fleet/radio_watch.h"

namespace usar::app {

/// Asks the wireless server beside the server that the window is connected to, while there are two radios or more.
/// GUI thread.
class RadioDesk : public QObject {
    Q_OBJECT
public:
    explicit RadioDesk(const DeskContext& context);

    void registerCommands();
    /// Once commands are registered.
    void wire();

private:
    using Pair = std::pair<QString, QString>;
    void spawnStation();
    void showOnMap(bool on);
    void follow(const link::LinkStatus& status);
    void followRobots();
    void take(const link::RadioStrengths& strengths);
    void tell(const widgets::RadioLink& link);
    void explainEmptiness();

    DeskContext desk_;
    mission::RadioWatch watch_;
    server::ChannelPorts ports_; ///< of the embedded simulator
    QStringList robots_;
    link::LinkStatus status_;
    std::map<Pair, bool> linked_; ///< as it was told last
    bool connected_ = false;
};

} // namespace usar::app
