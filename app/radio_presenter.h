// Radio links of the window's robots: in their dock, on the map, and as notices where one is lost.
#pragma once

#include <map>
#include <utility>

#include <QObject>

#include "app/mission_control.h"
#include "app/radio_watch.h"
#include "app/window_views.h"

namespace usar::app {

/// Asks the wireless server beside the server that the window is connected to, while there are two radios or more.
/// GUI thread.
class RadioPresenter : public QObject {
    Q_OBJECT
public:
    RadioPresenter(MissionControl& control, WindowViews& views, QObject* parent = nullptr);

    /// The button of the empty dock.
    void setStationAction(QAction* action);

private:
    using Pair = std::pair<QString, QString>;
    void follow(const link::LinkStatus& status);
    void followRobots();
    void take(const link::RadioStrengths& strengths);
    void tell(const widgets::RadioLink& link);
    void explainEmptiness();

    MissionControl& control_;
    WindowViews& views_;
    RadioWatch watch_;
    ChannelPorts ports_; ///< of the embedded simulator
    QStringList robots_;
    link::LinkStatus status_;
    std::map<Pair, bool> linked_; ///< as it was told last
    bool connected_ = false;
    QAction* station_action_ = nullptr;
};

} // namespace usar::app
