// A simulation with base stations that a test can put anywhere, the radio's servers beside it, and programs that talk
// to them.
#pragma once

#include <map>
#include <memory>
#include <string>

#include <QTcpServer>
#include <QTcpSocket>

#include "core/server/com_server.h"
#include "core/server/radio_relay.h"
#include "core/server/wireless_server.h"
#include "core/sim/simulation.h"

namespace usar::server {

/// Flat ground of 400 m with a house of many walls in the middle. Radios are base stations, for those stand where they
/// are put.
class RadioWorld {
public:
    /// As `walls` boxes across the x axis around x = 0.
    explicit RadioWorld(int walls = 0, sim::RadioParameters radio = {});

    /// A radio of that name is there from now on, and no longer where it was before.
    void place(const std::string& name, double x_m, double y_m = 0.0);
    void takeAway(const std::string& name);

    std::unique_ptr<sim::Simulation> simulation;
    RadioRelay relay;
    WirelessServer wireless;
    ComServer com;
    quint16 wireless_port = *wireless.listen(0);
    quint16 com_port = *com.listen(0);

private:
    std::map<std::string, sim::ClientId> clients_;
};

/// A program on the other side of a socket: keeps what it hears.
class Peer {
public:
    Peer() = default;
    explicit Peer(quint16 port) { call(port); }
    void call(quint16 port);
    void say(const QByteArray& bytes) { socket().write(bytes); }
    const QByteArray& heard() const { return heard_; }
    void forget() { heard_.clear(); }
    bool open() const { return socket_ && socket_->state() == QAbstractSocket::ConnectedState; }
    /// Says it and waits for all of the reply's last line.
    QByteArray ask(const QByteArray& request, const QByteArray& end = "\r\n");
    QTcpSocket& socket() { return *socket_; }

private:
    friend class Listener;
    void take(QTcpSocket* socket);
    std::unique_ptr<QTcpSocket> socket_;
    QByteArray heard_;
};

/// Where a robot listens; the newest call is its peer.
class Listener {
public:
    Listener();
    quint16 port() const { return server_.serverPort(); }
    QByteArray portText() const { return QByteArray::number(port()); }
    int calls() const { return calls_; }
    Peer peer;

private:
    QTcpServer server_;
    int calls_ = 0;
};

} // namespace usar::server
