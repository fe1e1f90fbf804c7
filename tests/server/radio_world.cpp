#include "tests/server/radio_world.h"

#include <stdexcept>

#include <QByteArray>
#include <QHostAddress>
#include <QObject>
#include <QTcpServer>
#include <QTcpSocket>
#include <QTest>

#include "tests/doubles/test_worlds.h"
#include "tests/suite/waiting.h"

namespace usar::server {

namespace {

std::unique_ptr<sim::Simulation> walled(int walls, const sim::RadioParameters& radio) {
    sim::World world = doubles::flatWorld(400.0);
    for (int i = 0; i < walls; ++i)
        world.boxes.push_back({Pose{{i - walls / 2.0, 0.0, 2.0}, 0.0, 0.0, 0.0}, {0.2, 20.0, 4.0}});
    sim::SimulationOptions options;
    options.radio = radio;
    auto made = sim::Simulation::make(std::move(world), options);
    if (!made)
        throw std::runtime_error(made.error().text());
    return *std::move(made);
}

} // namespace

RadioWorld::RadioWorld(int walls, sim::RadioParameters radio)
    : simulation(walled(walls, radio))
    , relay(*simulation)
    , wireless(relay)
    , com(relay) {}

void RadioWorld::place(const std::string& name, double x_m, double y_m) {
    if (const auto old = clients_.find(name); old != clients_.end())
        simulation->disconnect(old->second);
    const sim::ClientId client = clients_[name] = simulation->connect();
    simulation->receive(client, "INIT {ClassName USARBot.ComStation} {Name " + name + "} {Location " +
                                    std::to_string(x_m) + "," + std::to_string(-y_m) + ",-0.7}\r\n");
    simulation->step();
    relay.look();
}

void RadioWorld::takeAway(const std::string& name) {
    if (const auto old = clients_.find(name); old != clients_.end()) {
        simulation->disconnect(old->second);
        clients_.erase(old);
    }
    relay.look();
}

void Peer::call(quint16 port) {
    take(new QTcpSocket);
    socket_->connectToHost(QHostAddress::LocalHost, port);
}

void Peer::take(QTcpSocket* socket) {
    socket->setParent(nullptr);
    socket_.reset(socket);
    QObject::connect(socket, &QTcpSocket::readyRead, socket, [this] { heard_ += socket_->readAll(); });
    if (socket->isOpen())
        heard_ += socket->readAll();
}

QByteArray Peer::ask(const QByteArray& request, const QByteArray& end) {
    heard_.clear();
    say(request);
    while (!heard_.endsWith(end))
        if (!test::waitForSignal(&socket(), &QTcpSocket::readyRead, 5000))
            return "no answer";
    return heard_.chopped(end.size());
}

Listener::Listener() {
    QObject::connect(&server_, &QTcpServer::newConnection, &server_, [this] {
        ++calls_;
        peer.take(server_.nextPendingConnection());
    });
    server_.listen(QHostAddress::LocalHost, 0);
}

} // namespace usar::server
