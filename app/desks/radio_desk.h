// Desk of the radio dock: shows the radio links between robots, there and on the map, and reports lost ones.
#pragma once

#include <map>
#include <utility>

#include "app/desks/desk.h"
#include "core/mission/fleet/radio_watch.h"

namespace usar::app {

/// While there are at least two radios, asks the wireless server that belongs to the connected server for their signal
/// strengths. GUI thread.
class RadioDesk : public Desk {
    Q_OBJECT
public:
    using Desk::Desk;

    void registerCommands() override;
    void wire() override;

private:
    using Pair = std::pair<QString, QString>;
    /// Spawns a base station on the first free start pose.
    void spawnStation();
    void showOnMap(bool on);
    /// Connects to the wireless server, or disconnects, with the link to the bot server.
    void follow(const link::LinkStatus& status);
    void followRobots();
    void take(const link::RadioStrengths& strengths);
    void tell(const widgets::RadioLink& link);
    /// Says in the empty dock why there are no links, and what helps.
    void explainEmptiness();

    mission::RadioWatch watch_;
    server::ChannelPorts ports_;  ///< ports of the embedded simulator
    QStringList robots_;          ///< names of all live robots
    link::LinkStatus status_;     ///< state of the connection to the wireless server
    std::map<Pair, bool> linked_; ///< last reported state; only pairs that have been linked
    bool connected_ = false;      ///< to the bot server
};

} // namespace usar::app
