#include "app/host/headless_simulator.h"

#include "app/host/true_figures.h"
#include "core/link/across_threads.h"
#include "core/server/embedded/simulator_files.h"

namespace usar::app {

Result<std::unique_ptr<HeadlessSimulator>> HeadlessSimulator::start(const QString& world, const HeadlessSpec& spec) {
    auto loaded = server::loadWorld(world);
    if (!loaded)
        return tl::unexpected(loaded.error());
    return serve(*std::move(loaded), spec);
}

Result<std::unique_ptr<HeadlessSimulator>> HeadlessSimulator::serve(sim::World world, const HeadlessSpec& spec) {
    sim::SimulationOptions options;
    options.seed = spec.seed;
    options.faults = spec.faults;
    options.battery_life = sim::survey_battery_life;
    sim::RobotsRead robots = server::loadRobots();
    for (const Error& refused : robots.refused)
        qWarning("%s", refused.text().c_str());
    options.robots = std::make_shared<const sim::RobotCatalog>(std::move(robots.robots));
    auto simulation = sim::Simulation::make(std::move(world), options);
    if (!simulation)
        return tl::unexpected(simulation.error());
    std::unique_ptr<HeadlessSimulator> host(new HeadlessSimulator);
    host->simulation_ = simulation->get();
    host->rays_ = std::make_unique<sim::RayCaster>(host->simulation_->world());
    host->worker_->moveToThread(&host->thread_);
    QObject::connect(&host->thread_, &QThread::finished, host->worker_, &QObject::deleteLater);
    host->thread_.setObjectName("simulator");
    host->thread_.start();
    Result<quint16> port;
    const auto serve = [&] { // Sockets and timers must be made in the thread that uses them.
        host->server_ = new server::SimulatorServer(*std::move(simulation), host->worker_);
        port = host->server_->listen(0);
        host->server_->setTimeBeginsWithRobots(true);
        host->server_->setPace(spec.speed_x ? server::Pace::Factor : server::Pace::Fast, spec.speed_x.value_or(1.0));
    };
    link::postAndWait(host->worker_, serve);
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

void HeadlessSimulator::onFault(QObject* context, const std::function<void(const QString&)>& tell) {
    link::connectAcross(server_, &server::SimulatorServer::faultTurned, context, tell);
}

Rectangle HeadlessSimulator::extent() const {
    return sim::extentOf(simulation_->world());
}

mission::Truth HeadlessSimulator::truth() const {
    return {.surface_m = [this](const Vec2& point_m) { return rays_->surface_m(point_m); },
            .ground_m = [this](const Vec2& point_m) { return simulation_->world().terrain.height_m(point_m); }};
}

std::optional<mission::TrueFigures> HeadlessSimulator::figures() const {
    std::optional<mission::TrueFigures> figures;
    const auto look = [this, &figures] {
        const std::vector<sim::RobotTruth> robots = simulation_->robots();
        if (!robots.empty())
            figures = trueFiguresOf(robots.front());
    };
    link::postAndWait(worker_, look);
    return figures;
}

} // namespace usar::app
