#include "tests/doubles/meddling_relay.h"

#include <vector>

#include <QHostAddress>

namespace usar::test {

MeddlingRelay::MeddlingRelay(quint16 server_port, QObject* parent) : QObject(parent), server_port_(server_port) {
    connect(&server_, &QTcpServer::newConnection, this, &MeddlingRelay::accept);
    server_.listen(QHostAddress::LocalHost);
    own_port_ = server_.serverPort();
}

void MeddlingRelay::accept() {
    while (QTcpSocket* client = server_.nextPendingConnection()) {
        auto* upstream = new QTcpSocket(this);
        clients_[client] = upstream;
        connect(upstream, &QTcpSocket::readyRead, this, [=, this] { toClient(upstream, client); });
        connect(upstream, &QTcpSocket::connected, this, [=, this] { toServer(client, upstream); });
        connect(client, &QTcpSocket::readyRead, this, [=, this] { toServer(client, upstream); });
        connect(client, &QTcpSocket::disconnected, this, [=, this] {
            clients_.erase(client);
            upstream->abort();
            upstream->deleteLater();
            client->deleteLater();
        });
        upstream->connectToHost(QHostAddress::LocalHost, server_port_);
    }
}

void MeddlingRelay::toClient(QTcpSocket* server, QTcpSocket* client) {
    while (server->canReadLine() && clients_.contains(client)) {
        const QByteArray line = server->readLine();
        client->write(meddle ? meddle(line) : line);
    }
}

void MeddlingRelay::toServer(QTcpSocket* client, QTcpSocket* server) {
    if (server->state() == QAbstractSocket::ConnectedState)
        server->write(client->readAll());
}

void MeddlingRelay::say(const QByteArray& bytes) {
    for (const auto& [client, upstream] : clients_)
        client->write(bytes);
}

void MeddlingRelay::die() {
    server_.close();
    std::vector<QTcpSocket*> all;
    for (const auto& [client, upstream] : clients_)
        all.push_back(client);
    for (QTcpSocket* client : all)
        client->abort();
}

void MeddlingRelay::revive() {
    server_.listen(QHostAddress::LocalHost, own_port_);
}

} // namespace usar::test
