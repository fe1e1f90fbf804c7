// Desk of the radio dock: shows the radio links between robots, there and on the map, and reports lost ones.
#pragma once

#include "app/desks/desk.h"
#include "core/link/wireless_client.h"
#include "core/mission/fleet/own_thread.h"
#include "widgets/models/radio_links.h"

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
    /// Spawns a base station on the first free start pose.
    void spawnStation();
    /// Shows or hides the lines between robots on the map.
    void showOnMap(bool on);
    /// Connects to the wireless server, or disconnects, with the link to the bot server.
    void follow(const link::LinkStatus& status);
    /// Requests the strengths between the robots that are spawned now.
    void followRobots();
    /// Shows new strengths in the dock and on the map, and reports lost and recovered links.
    void take(const link::RadioStrengths& strengths);
    /// Says in the empty dock why there are no links, and what helps.
    void explainEmptiness();

    server::ChannelPorts ports_; ///< ports of the embedded simulator
    QStringList robots_;         ///< names of all live robots
    link::LinkStatus status_;    ///< state of the connection to the wireless server
    widgets::RadioLosses losses_;
    bool connected_ = false; ///< to the bot server
    mission::OwnThread<link::WirelessClient> client_{"radio"};
};

} // namespace usar::app
