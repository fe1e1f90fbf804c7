// Connections within this machine. No server of the simulator is reachable from other hosts.
#pragma once

#include <string>

#include <QTcpServer>
#include <QTcpSocket>

#include "core/base/result.h"

namespace usar::server {

/// Makes `server` listen on a loopback port; port 0 chooses a free one. Returns the port. If it is in use, the error
/// names `option`, the command line option that chooses another.
Result<quint16> listenOnLoopback(QTcpServer& server, quint16 port, const std::string& option);

/// Starts connecting to a port of this machine. The new socket's own port is known before the call is answered. The
/// caller owns the socket.
QTcpSocket* callLoopback(quint16 port);

/// Closes a connection that was just accepted, because there is no room for it.
void refuse(QTcpSocket* socket);

} // namespace usar::server
