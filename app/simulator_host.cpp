#include "app/simulator_host.h"

#include <algorithm>
#include <utility>

#include "app/simulator_files.h"
#include "app/world_picture.h"
#include "core/base/text.h"
#include "core/protocol/commands/spawn.h"

namespace usar::app {

SimulatorHost::SimulatorHost(QObject* parent) : QObject(parent) {}

SimulatorHost::~SimulatorHost() {
    next_.reset();
    QThread* thread = thread_;
    retire();
    if (thread) {
        thread->wait();
        delete thread;
    }
}

void SimulatorHost::start(const SimulatorSpec& spec) {
    if (!thread_)
        return launch(spec);
    next_ = spec;
    retire();
}

void SimulatorHost::stop() {
    next_.reset();
    retire();
}

void SimulatorHost::launch(const SimulatorSpec& spec) {
    thread_ = new QThread;
    thread_->setObjectName("simulator");
    worker_ = new QObject;
    worker_->moveToThread(thread_);
    connect(thread_, &QThread::finished, worker_, &QObject::deleteLater);
    connect(thread_, &QThread::finished, this, [this, thread = thread_] {
        thread->deleteLater();
        thread_ = nullptr;
        if (next_)
            launch(*std::exchange(next_, std::nullopt));
    });
    thread_->start();
    QMetaObject::invokeMethod(worker_, [this, spec, worker = worker_] { serve(spec, worker); });
}

/// Sockets and timers end in the thread that they live in, then the thread itself.
void SimulatorHost::retire() {
    server_ = nullptr;
    if (!worker_)
        return;
    QMetaObject::invokeMethod(worker_, [worker = worker_] {
        qDeleteAll(worker->children());
        worker->thread()->quit();
    });
    worker_ = nullptr;
}

/// Runs in the simulator's thread, as `serve` does.
Result<std::unique_ptr<sim::Simulation>> SimulatorHost::begin(const SimulatorSpec& spec, sim::RobotsRead& robots) {
    auto catalog = std::make_shared<const sim::RobotCatalog>(std::move(robots.robots));
    if (!spec.snapshot.isEmpty())
        return resumeSimulation(spec.snapshot, std::move(catalog));
    Result<sim::World> world = loadWorld(spec.world);
    if (!world)
        return tl::unexpected(world.error());
    return sim::Simulation::make(std::move(*world), {.seed = spec.seed,
                                                     .battery_life = sim::survey_battery_life,
                                                     .robots = std::move(catalog),
                                                     .faults = spec.faults,
                                                     .world_source = spec.world.toStdString()});
}

void SimulatorHost::serve(const SimulatorSpec& spec, QObject* worker) {
    sim::RobotsRead robots = loadRobots();
    QStringList classes;
    QStringList classes_with_camera;
    for (const sim::RobotModel& robot : robots.robots) {
        classes << QString::fromStdString(robot.class_name);
        const bool sees = std::ranges::any_of(
            robot.sensors, [](const sim::SensorModel& sensor) { return sameWord(sensor.type, "Camera"); });
        if (sees)
            classes_with_camera << classes.back();
    }
    classes << QString::fromStdString(std::string(protocol::station_class)).section('.', -1);
    for (const Error& refused : robots.refused)
        emit robotRefused(QString::fromStdString(refused.text()));
    auto simulation = begin(spec, robots);
    if (!simulation)
        return emit failed(QString::fromStdString(simulation.error().text()));
    WorldPicture picture = pictureOf((*simulation)->world());
    picture.robot_classes = classes;
    picture.camera_classes = classes_with_camera;
    const std::vector<sim::Simulation::Orphan> waiting = (*simulation)->orphans();
    auto* server = new link::SimulatorServer(std::move(*simulation), worker);
    Result<quint16> port = server->listen(spec.port);
    if (!port) {
        port = server->listen(0);
        if (!port)
            return emit failed(QString::fromStdString(port.error().text()));
        emit movedPort(tr("Port %1 is in use by another program; the embedded simulator listens on port %2 instead. "
                          "Programs that join it must use that one.")
                           .arg(spec.port)
                           .arg(*port));
    }
    connect(server, &link::SimulatorServer::figuresChanged, this, &SimulatorHost::figuresChanged);
    connect(server, &link::SimulatorServer::robotsChanged, this, &SimulatorHost::robotsChanged);
    connect(server, &link::SimulatorServer::logged, this, &SimulatorHost::noted);
    connect(server, &link::SimulatorServer::faultsChanged, this, &SimulatorHost::faultsChanged);
    connect(server, &link::SimulatorServer::faultTurned, this, &SimulatorHost::faultTurned);
    emit faultsChanged(server->simulation().faults()); // those of the one before are gone
    const OpenChannels channels = openChannels(*server, spec.port == 0 ? ChannelPorts::anywhere() : spec.channels);
    for (const QString& sentence : channels.sentences)
        emit movedPort(sentence);
    QMetaObject::invokeMethod(this, [this, server, worker, port = *port, picture, waiting, ports = channels.ports] {
        if (worker != worker_)
            return; // retired while it was loading
        server_ = server;
        emit channelsOpened(ports);
        emit ready(port, picture, waiting);
    });
}

void SimulatorHost::setPace(link::Pace pace, double factor) {
    if (server_)
        QMetaObject::invokeMethod(server_, [server = server_, pace, factor] { server->setPace(pace, factor); });
}

void SimulatorHost::addFaults(const std::vector<sim::Fault>& faults) {
    if (server_)
        QMetaObject::invokeMethod(server_, [server = server_, faults] { server->addFaults(faults, true); });
}

void SimulatorHost::endFault(int id) {
    if (server_)
        QMetaObject::invokeMethod(server_, [server = server_, id] { server->endFault(id); });
}

void SimulatorHost::saveSnapshot(const QString& path) {
    if (!server_)
        return;
    QMetaObject::invokeMethod(server_, [this, server = server_, path] {
        const auto saved = app::saveSnapshot(server->simulation(), path);
        if (saved)
            emit snapshotSaved(path);
        else
            emit snapshotFailed(QString::fromStdString(saved.error().text()));
    });
}

void SimulatorHost::letOrphansGo() {
    if (server_)
        QMetaObject::invokeMethod(server_, [server = server_] { server->letOrphansGo(); });
}

void SimulatorHost::stepOnce() {
    if (server_)
        QMetaObject::invokeMethod(server_, [server = server_] { server->stepOnce(); });
}

} // namespace usar::app
