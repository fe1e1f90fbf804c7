// A wire between a client and a server that treats the bytes as badly as TCP may: cut anywhere, glued, cut off.
#pragma once

#include <QObject>
#include <QPointer>
#include <QTcpServer>
#include <QTcpSocket>

#include "core/base/random.h"

namespace usar::test {

/// Relays one client at a time to a loopback port, in pieces of random sizes. Lives in the test's thread.
class RoughRelay : public QObject {
    Q_OBJECT
public:
    explicit RoughRelay(quint16 server_port, QObject* parent = nullptr);

    quint16 port() const { return server_.serverPort(); }
    /// Pieces are 1 to this many bytes long.
    int longest_piece = 100;
    /// After so many bytes from the server, in the middle of whatever it is, both ends are cut off; 0 = never.
    qint64 cut_after_bytes = 0;

private:
    void accept();
    void relay(QTcpSocket* from, QTcpSocket* to, bool from_server);

    quint16 server_port_;
    QTcpServer server_;
    QPointer<QTcpSocket> client_;
    QPointer<QTcpSocket> upstream_;
    qint64 relayed_ = 0;
    Random random_ = seeded(1, 1);
};

} // namespace usar::test
