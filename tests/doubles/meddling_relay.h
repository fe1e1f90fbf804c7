// A wire to a server on which a test can change, swallow and add lines.
#pragma once

#include <functional>
#include <map>

#include <QByteArray>
#include <QObject>
#include <QPointer>
#include <QTcpServer>
#include <QTcpSocket>

namespace usar::test {

/// Relays any number of clients to a loopback port, line by line. Lives in the test's thread.
class MeddlingRelay : public QObject {
    Q_OBJECT
public:
    explicit MeddlingRelay(quint16 server_port, QObject* parent = nullptr);
    ~MeddlingRelay() override { die(); } // a socket that closes later than the map would look into it

    quint16 port() const { return server_.serverPort(); }
    /// Each line of the server with its terminator; what is returned goes on to the client. Unset: all goes on.
    std::function<QByteArray(const QByteArray& line)> meddle;
    /// To every client.
    void say(const QByteArray& bytes);
    /// Cuts every client off and takes no new one.
    void die();
    /// Takes clients again, on the same port.
    void revive();

private:
    void accept();
    void toClient(QTcpSocket* server, QTcpSocket* client);
    void toServer(QTcpSocket* client, QTcpSocket* server);

    quint16 server_port_;
    quint16 own_port_ = 0;
    QTcpServer server_;
    std::map<QTcpSocket*, QPointer<QTcpSocket>> clients_; ///< and the connection made for each
};

} // namespace usar::test
