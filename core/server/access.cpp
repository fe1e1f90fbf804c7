#include "core/server/access.h"

#include <algorithm>

#include <QNetworkProxy>

namespace usar::server {

namespace {

/// An IPv4 address that a socket for both kinds gives as ::ffff:10.1.2.3 is an IPv4 address.
QHostAddress plain(const QHostAddress& address) {
    bool is_four = false;
    const quint32 four = address.toIPv4Address(&is_four);
    return is_four ? QHostAddress(four) : address;
}

} // namespace

Result<Access> Access::make(const QString& address, const QStringList& networks) {
    Access access;
    if (!address.isEmpty() && !access.address_.setAddress(address))
        return failure("'" + address.toStdString() + "' is no address of this machine", "--bind",
                       "Give an IP address such as 192.168.1.5, or 0.0.0.0 for all");
    for (const QString& network : networks) {
        const std::pair<QHostAddress, int> subnet = QHostAddress::parseSubnet(network);
        if (subnet.first.isNull() || subnet.second < 0)
            return failure("'" + network.toStdString() + "' is no network", "--allow",
                           "Give one such as 192.168.1.0/24, or a single address");
        access.networks_.push_back(subnet);
    }
    access.text_ = networks.join(", ");
    if (!access.address_.isLoopback() && networks.isEmpty())
        return failure("nobody would be allowed to connect to " + address.toStdString(), "--bind",
                       "Name the network of your robots' programs too: --allow 192.168.1.0/24");
    if (access.address_.isLoopback() && !networks.isEmpty())
        return failure("other machines cannot reach the loopback address", "--allow",
                       "Say where to listen too: --bind 0.0.0.0");
    return access;
}

bool Access::admits(const QHostAddress& peer) const {
    const QHostAddress caller = plain(peer);
    return caller.isLoopback() ||
           std::ranges::any_of(networks_, [&](const auto& one) { return caller.isInSubnet(one); });
}

QString endpointText(const QHostAddress& address, quint16 port) {
    const QString text = plain(address).toString();
    return (text.contains(':') ? "[" + text + "]" : text) + ":" + QString::number(port);
}

Result<quint16> GuardedServer::open(quint16 port, const std::string& option) {
    if (listen(access_.address(), port))
        return serverPort();
    const std::string where = endpointText(access_.address(), port).toStdString();
    if (serverError() == QAbstractSocket::AddressInUseError)
        return failure("port " + std::to_string(port) + " is already in use", where,
                       "Choose another one with " + option + ", or end the program that listens there");
    if (serverError() == QAbstractSocket::SocketAddressNotAvailableError)
        return failure("this machine has no such address", where,
                       "Give one of its own with --bind, or 0.0.0.0 for all");
    return failure(errorString().toStdString(), where, "Choose another port with " + option);
}

void GuardedServer::incomingConnection(qintptr descriptor) {
    auto* const socket = new QTcpSocket(this);
    const bool here = socket->setSocketDescriptor(descriptor);
    if (here && access_.admits(socket->peerAddress()))
        return addPendingConnection(socket);
    if (here)
        emit turnedAway(tr("hung up on %1, which --allow does not name").arg(plain(socket->peerAddress()).toString()));
    refuse(socket);
}

QTcpSocket* call(const QHostAddress& host, quint16 port) {
    auto* socket = new QTcpSocket;
    socket->setProxy(QNetworkProxy::NoProxy);
    socket->bind(plain(host).isLoopback() ? QHostAddress(QHostAddress::LocalHost) : QHostAddress(QHostAddress::Any), 0);
    socket->connectToHost(plain(host), port);
    return socket;
}

void refuse(QTcpSocket* socket) {
    socket->abort();
    socket->deleteLater();
}

} // namespace usar::server
