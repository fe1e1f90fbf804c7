#include "tests/doubles/rough_relay.h"

#include <QHostAddress>

namespace usar::test {

RoughRelay::RoughRelay(quint16 server_port, QObject* parent) : QObject(parent), server_port_(server_port) {
    connect(&server_, &QTcpServer::newConnection, this, &RoughRelay::accept);
    server_.listen(QHostAddress::LocalHost);
}

void RoughRelay::accept() {
    client_ = server_.nextPendingConnection();
    upstream_ = new QTcpSocket(this);
    relayed_ = 0;
    connect(upstream_, &QTcpSocket::readyRead, this, [this] { relay(upstream_, client_, true); });
    connect(client_, &QTcpSocket::readyRead, this, [this] { relay(client_, upstream_, false); });
    client_->setSocketOption(QAbstractSocket::LowDelayOption, 1);
    connect(upstream_, &QTcpSocket::connected, this, [this] {
        upstream_->setSocketOption(QAbstractSocket::LowDelayOption, 1);
        relay(client_, upstream_, false);
    });
    connect(client_, &QTcpSocket::disconnected, upstream_, &QTcpSocket::disconnectFromHost);
    upstream_->connectToHost(QHostAddress::LocalHost, server_port_);
}

void RoughRelay::relay(QTcpSocket* from, QTcpSocket* to, bool from_server) {
    while (from && to && to->state() == QAbstractSocket::ConnectedState && from->bytesAvailable() > 0) {
        const auto piece = 1 + static_cast<qint64>(random_() % static_cast<std::uint64_t>(longest_piece));
        const QByteArray bytes = from->read(piece);
        to->write(bytes);
        to->flush();
        relayed_ += from_server ? bytes.size() : 0;
        if (cut_after_bytes > 0 && relayed_ >= cut_after_bytes) {
            cut_after_bytes = 0;
            server_.close();
            to->disconnectFromHost();
            from->abort();
        }
    }
}

} // namespace usar::test
