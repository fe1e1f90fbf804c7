#include "core/server/loopback.h"

#include <QHostAddress>
#include <QNetworkProxy>

namespace usar::server {

Result<quint16> listenOnLoopback(QTcpServer& server, quint16 port, const std::string& option) {
    if (server.listen(QHostAddress::LocalHost, port))
        return server.serverPort();
    const std::string where = "127.0.0.1:" + std::to_string(port);
    if (server.serverError() == QAbstractSocket::AddressInUseError)
        return failure("port " + std::to_string(port) + " is already in use", where,
                       "Choose another one with " + option + ", or end the program that listens there");
    return failure(server.errorString().toStdString(), where, "Choose another port with " + option);
}

QTcpSocket* callLoopback(quint16 port) {
    auto* socket = new QTcpSocket;
    socket->setProxy(QNetworkProxy::NoProxy);
    socket->bind(QHostAddress::LocalHost, 0);
    socket->connectToHost(QHostAddress::LocalHost, port);
    return socket;
}

void refuse(QTcpSocket* socket) {
    socket->abort();
    socket->deleteLater();
}

} // namespace usar::server
