#include "tests/doubles/fake_server.h"

#include <QHostAddress>

namespace usar::test {

FakeServer::FakeServer(QObject* parent) : QObject(parent) {
    connect(&server_, &QTcpServer::newConnection, this, &FakeServer::accept);
}

bool FakeServer::listen(quint16 port) {
    return server_.listen(QHostAddress::LocalHost, port);
}

void FakeServer::accept() {
    while (QTcpSocket* socket = server_.nextPendingConnection()) {
        ++connection_count_;
        if (kept_) {
            socket->setParent(this);
            continue;
        }
        client_ = socket;
        connect(socket, &QTcpSocket::readyRead, this, [this, socket] { read(socket); });
        connect(socket, &QTcpSocket::disconnected, socket, &QObject::deleteLater);
        if (on_connect)
            on_connect();
    }
}

void FakeServer::setDeaf(bool on) {
    deaf_ = on;
    if (!client_)
        return;
    client_->setSocketOption(QAbstractSocket::ReceiveBufferSizeSocketOption, on ? 1 << 14 : 1 << 22);
    client_->setReadBufferSize(on ? 1 : 0); // once it is full, the socket stops reading
    if (!on)
        read(client_);
}

void FakeServer::read(QTcpSocket* socket) {
    if (deaf_)
        return;
    while (socket->canReadLine()) {
        QByteArray line = socket->readLine();
        while (line.endsWith('\n') || line.endsWith('\r'))
            line.chop(1);
        if (kept_ && socket != kept_)
            continue;
        heard_.append(line);
        speaking_ = socket;
        if (on_line)
            on_line(line);
        speaking_.clear();
    }
}

void FakeServer::say(const QByteArray& bytes) {
    const QPointer<QTcpSocket>& to = speaking_ ? speaking_ : kept_ ? kept_ : client_;
    if (to) {
        to->write(bytes);
        to->flush();
    }
}

void FakeServer::sayInChunks(const QByteArray& bytes, qsizetype chunk_size) {
    for (qsizetype at = 0; at < bytes.size(); at += chunk_size)
        say(bytes.mid(at, chunk_size));
}

void FakeServer::hangUp() {
    if (client_)
        client_->disconnectFromHost();
}

QList<QByteArray> FakeServer::heardOf(const QByteArray& word) const {
    QList<QByteArray> lines;
    for (const QByteArray& line : heard_)
        if (line.startsWith(word))
            lines.append(line);
    return lines;
}

} // namespace usar::test
