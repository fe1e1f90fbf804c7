// The servers of further channels beside a simulator's bot port (protocol.md 6).
#pragma once

#include <QMetaType>
#include <QStringList>

#include "core/protocol/usual_values.h"
#include "core/server/image_server.h"
#include "core/server/simulator_server.h"

namespace usar::server {

/// Wanted, or listened on; 0 wants a free one and means "none" of what is open.
struct ChannelPorts {
    quint16 image = protocol::usual_port::image;
    quint16 wireless = protocol::usual_port::wireless;
    quint16 comserver = protocol::usual_port::com_server;
    quint16 cominterface = protocol::usual_port::com_interface;
    bool operator==(const ChannelPorts&) const = default;

    /// Free ones for all: for a simulator whose bot port is chosen freely, too.
    static ChannelPorts anywhere() { return {.image = 0, .wireless = 0, .comserver = 0, .cominterface = 0}; }
};

struct OpenChannels {
    ChannelPorts ports = ChannelPorts::anywhere(); ///< where they listen now
    QStringList sentences;                         ///< about ports of other programs, each with what was done about it
};

/// Opens them as children of `server`, in its thread; they end with it. A port in use is no failure: another one is
/// taken, and said.
OpenChannels openChannels(server::SimulatorServer& server, const ChannelPorts& wanted,
                          const server::ImageServerOptions& images = {});

} // namespace usar::server

Q_DECLARE_METATYPE(usar::server::ChannelPorts)
