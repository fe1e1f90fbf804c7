#include "core/server/embedded/simulator_host.h"

#include <utility>

#include "core/link/across_threads.h"
#include "core/server/embedded/log_words.h"
#include "core/server/embedded/simulator_files.h"
#include "core/sim/robots/footprint.h"

namespace usar::server {

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
    link::post(worker_, [this, spec, worker = worker_] { serve(spec, worker); });
}

/// Destroys sockets and timers in the simulator's thread, then ends that thread.
void SimulatorHost::retire() {
    server_ = nullptr;
    if (!worker_)
        return;
    link::post(worker_, [worker = worker_] {
        qDeleteAll(worker->children());
        worker->thread()->quit();
    });
    worker_ = nullptr;
}

void SimulatorHost::serve(const SimulatorSpec& spec, QObject* worker) {
    const bool is_loaded = spec.loaded && spec.loaded->simulation;
    Result<LoadedSimulation> loaded = is_loaded ? std::move(*spec.loaded) : loadSimulation(spec);
    if (!loaded)
        return emit failed(QString::fromStdString(loaded.error().text()));
    for (const QString& refused : loaded->refused_robots)
        emit robotRefused(refused);
    WorldPicture picture = pictureOf(loaded->simulation->world());
    picture.robot_classes = loaded->robot_classes;
    picture.camera_classes = loaded->camera_classes;
    picture.robot_outlines = loaded->robot_outlines;
    const std::vector<sim::Simulation::Orphan> waiting = loaded->simulation->orphans();
    auto* server = new SimulatorServer(std::move(loaded->simulation), worker);
    server->setAccess(spec.access);
    server->setTimeBeginsWithRobots(spec.time_begins_with_robots);
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
    if (spec.access.isOpen())
        emit movedPort(tr("Programs on other machines may connect to the embedded simulator on %1: %2.")
                           .arg(endpointText(spec.access.address(), *port), spec.access.networks()));
    wire(*server);
    emit faultsChanged(server->simulation().faults()); // Replaces those of the previous simulator.
    const OpenChannels channels = openChannels(*server, spec.port == 0 ? ChannelPorts::anywhere() : spec.channels);
    for (const QString& sentence : channels.sentences)
        emit movedPort(sentence);
    link::post(this, [this, server, worker, port = *port, picture, waiting, ports = channels.ports] {
        if (worker != worker_)
            return; // It was stopped while it was loading.
        server_ = server;
        emit channelsOpened(ports);
        emit ready(port, picture, waiting);
    });
}

void SimulatorHost::wire(const SimulatorServer& server) {
    using Server = SimulatorServer;
    link::connectAcross(&server, &Server::figuresChanged, this, &SimulatorHost::figuresChanged);
    link::connectAcross(&server, &Server::robotsChanged, this, &SimulatorHost::robotsChanged);
    link::connectAcross(&server, &Server::objectsChanged, this, &SimulatorHost::objectsChanged);
    link::connectAcross(&server, &Server::marksLeft, this, &SimulatorHost::marksLeft);
    link::connectAcross(&server, &Server::logged, this, [this](const QString& sentence) {
        if (const QString notice = noticeOfLog(sentence); !notice.isEmpty())
            emit noted(notice);
    });
    link::connectAcross(&server, &Server::objectRefused, this, &SimulatorHost::objectRefused);
    link::connectAcross(&server, &Server::faultsChanged, this, &SimulatorHost::faultsChanged);
    link::connectAcross(&server, &Server::faultTurned, this, &SimulatorHost::faultTurned);
}

/// Runs a call in the simulator's thread; does nothing while no simulator is ready.
template <class Call>
void SimulatorHost::post(Call call) {
    if (server_)
        link::post(server_, [server = server_, call] { call(*server); });
}

void SimulatorHost::learn(const QString& robot_file) {
    post([this, robot_file](SimulatorServer& server) {
        auto robot = sim::readRobot(robot_file.toStdString());
        if (!robot)
            return emit robotRefused(QString::fromStdString(robot.error().text()));
        emit robotLearned(robot_file, QString::fromStdString(robot->class_name), hasCamera(*robot),
                          sim::footprintOf(*robot));
        server.simulation().learn(*std::move(robot));
    });
}

void SimulatorHost::setPace(Pace pace, double factor) {
    post([=](SimulatorServer& server) { server.setPace(pace, factor); });
}

void SimulatorHost::addFaults(const std::vector<sim::Fault>& faults) {
    post([faults](SimulatorServer& server) { server.addFaults(faults, true); });
}

void SimulatorHost::endFault(int id) {
    post([id](SimulatorServer& server) { server.endFault(id); });
}

void SimulatorHost::saveSnapshot(const QString& path) {
    post([this, path](SimulatorServer& server) {
        const auto saved = server::saveSnapshot(server.simulation(), path);
        if (saved)
            emit snapshotSaved(path);
        else
            emit snapshotFailed(QString::fromStdString(saved.error().text()));
    });
}

void SimulatorHost::letOrphansGo() {
    post([](SimulatorServer& server) { server.letOrphansGo(); });
}

void SimulatorHost::stepOnce() {
    post([](SimulatorServer& server) { server.stepOnce(); });
}

} // namespace usar::server
