#include "core/server/embedded/headless_simulator.h"

#include <QPointer>

#include "core/link/across_threads.h"
#include "core/server/embedded/simulator_files.h"

namespace usar::server {

Result<std::unique_ptr<HeadlessSimulator>> HeadlessSimulator::start(const QString& world, const HeadlessSpec& spec) {
    return loadWorld(world).and_then([&](sim::World&& loaded) { return serve(std::move(loaded), spec); });
}

Result<std::unique_ptr<HeadlessSimulator>> HeadlessSimulator::serve(sim::World world, const HeadlessSpec& spec) {
    return sim::PreparedWorld::make(std::move(world)).and_then([&](sim::PreparedWorld&& prepared) {
        return serve(std::move(prepared), spec);
    });
}

Result<std::unique_ptr<HeadlessSimulator>> HeadlessSimulator::serve(sim::PreparedWorld world,
                                                                    const HeadlessSpec& spec) {
    sim::RobotsRead robots = loadRobots();
    for (const Error& refused : robots.refused)
        qWarning("%s", refused.text().c_str());
    auto simulation = sim::Simulation::make(
        std::move(world), {.seed = spec.seed,
                           .battery_life = spec.battery_life,
                           .robots = std::make_shared<const sim::RobotCatalog>(std::move(robots.robots)),
                           .faults = spec.faults,
                           .keeps_journal = false}); // Nobody can ask for a snapshot, and a mission may last for days.
    if (!simulation)
        return tl::unexpected(simulation.error());
    std::unique_ptr<HeadlessSimulator> host(new HeadlessSimulator);
    host->simulation_ = simulation->get();
    if (spec.own_thread) {
        host->worker_->moveToThread(&host->thread_);
        QObject::connect(&host->thread_, &QThread::finished, host->worker_, &QObject::deleteLater);
        host->thread_.setObjectName("simulator");
        host->thread_.start();
    }
    Result<quint16> port;
    host->run([&] { // Sockets and timers must be made in the thread that uses them.
        host->server_ = new SimulatorServer(*std::move(simulation), host->worker_);
        port = host->server_->listen(0);
        host->server_->setTimeBeginsWithRobots(true);
        host->server_->setPace(spec.speed_x ? Pace::Factor : Pace::Fast, spec.speed_x.value_or(1.0));
    });
    if (!port)
        return tl::unexpected(port.error());
    host->port_ = *port;
    return host;
}

HeadlessSimulator::~HeadlessSimulator() {
    if (!thread_.isRunning())
        delete worker_;
    thread_.quit();
    thread_.wait();
}

void HeadlessSimulator::run(const std::function<void()>& call) const {
    if (thread_.isRunning())
        link::postAndWait(worker_, call);
    else
        call();
}

link::InProcessServer HeadlessSimulator::inProcess() {
    if (thread_.isRunning())
        return {};
    return [server = QPointer(server_)](QTcpSocket* client) {
        if (server)
            server->accept(client);
        else
            client->deleteLater(); // The client hears that the server has closed the connection.
    };
}

void HeadlessSimulator::onFault(QObject* context, const std::function<void(const QString&)>& tell) {
    link::connectAcross(server_, &SimulatorServer::faultTurned, context, tell);
}

void HeadlessSimulator::onVanished(QObject* context, const std::function<void(const QString&)>& tell) {
    link::connectAcross(server_, &SimulatorServer::robotVanished, context, tell);
}

void HeadlessSimulator::onSilenced(QObject* context, const std::function<void(const QString&)>& tell) {
    link::connectAcross(server_, &SimulatorServer::robotSilenced, context, tell);
}

Rectangle HeadlessSimulator::extent() const {
    return sim::extentOf(simulation_->world());
}

double HeadlessSimulator::dryAbove_m() const {
    return sim::dryAbove_m(simulation_->world());
}

std::optional<sim::RobotTruth> HeadlessSimulator::firstRobot() const {
    std::optional<sim::RobotTruth> first;
    run([this, &first] {
        const std::vector<sim::RobotTruth> robots = simulation_->robots();
        first = robots.empty() ? simulation_->lastGone() : robots.front();
    });
    return first;
}

} // namespace usar::server
