// The servers of a simulator's other channels, besides the bot port (protocol.md 6).
#pragma once

#include <QStringList>

#include "core/protocol/usual_values.h"
#include "core/server/image_server.h"
#include "core/server/simulator_server.h"

namespace usar::server {

/// TCP ports of the channels: either those that are wanted (0: any free one) or those that are listened on (0: the
/// channel could not be opened).
struct ChannelPorts {
    quint16 image = protocol::usual_port::image;
    quint16 wireless = protocol::usual_port::wireless;
    quint16 comserver = protocol::usual_port::com_server;
    quint16 cominterface = protocol::usual_port::com_interface;
    bool operator==(const ChannelPorts&) const = default;

    /// Any free port for every channel, for a simulator that also takes any free bot port.
    static ChannelPorts anywhere() { return {.image = 0, .wireless = 0, .comserver = 0, .cominterface = 0}; }
};

/// The result of `openChannels`.
struct OpenChannels {
    ChannelPorts ports = ChannelPorts::anywhere(); ///< the ports that are listened on
    QStringList sentences; ///< one for each wanted port that could not be used, with the port used instead
};

/// Opens the channels' servers as children of `server`, in whose thread it must be called. A port in use is not an
/// error: a free one is used instead, and a sentence says so.
OpenChannels openChannels(SimulatorServer& server, const ChannelPorts& wanted, const ImageServerOptions& images = {});

} // namespace usar::server
