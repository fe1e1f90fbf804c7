// Who may connect to the simulator's servers: programs on this machine, and others only from networks that were named.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <QHostAddress>
#include <QStringList>
#include <QTcpServer>
#include <QTcpSocket>

#include "core/base/result.h"

namespace usar::server {

/// Default-constructed: this machine alone.
class Access {
public:
    /// Listens on `address` and admits this machine and the networks, such as 10.1.0.0/16, fd00::/8 or 10.1.2.3.
    /// Anything but loopback needs both; empty texts mean this machine alone. The error names the option that is wrong.
    static Result<Access> make(const QString& address, const QStringList& networks);

    const QHostAddress& address() const { return address_; }
    bool admits(const QHostAddress& peer) const;
    /// True if other machines are admitted.
    bool isOpen() const { return !networks_.empty(); }
    /// The networks as they were given: "10.1.0.0/16, fd00::/8"; empty unless it is open.
    const QString& networks() const { return text_; }

private:
    QHostAddress address_ = QHostAddress(QHostAddress::LocalHost);
    std::vector<std::pair<QHostAddress, int>> networks_;
    QString text_;
};

/// "127.0.0.1:3000" or "[::1]:3000".
QString endpointText(const QHostAddress& address, quint16 port);

/// Hangs up on callers that may not connect, before a byte of theirs is read.
class GuardedServer : public QTcpServer {
    Q_OBJECT
public:
    using QTcpServer::QTcpServer;

    /// To be called before `open`.
    void setAccess(const Access& access) { access_ = access; }
    const Access& access() const { return access_; }
    /// Listens; port 0 chooses a free one. Returns the port. If it is in use, the error names `option`, the command
    /// line option that chooses another.
    Result<quint16> open(quint16 port, const std::string& option);

signals:
    /// A sentence about a caller that may not connect.
    void turnedAway(const QString& sentence);

protected:
    void incomingConnection(qintptr descriptor) override;

private:
    Access access_;
};

/// Starts connecting to a port of a machine that a robot's program runs on. The new socket's own port is known before
/// the call is answered. The caller owns the socket.
QTcpSocket* call(const QHostAddress& host, quint16 port);

/// Closes a connection that was just accepted, because there is no room for it.
void refuse(QTcpSocket* socket);

} // namespace usar::server
