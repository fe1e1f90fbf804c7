#include "core/server/simulator_server.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/numbers.h"

namespace usar::server {

namespace {

constexpr int report_interval_ms = 250;
constexpr qint64 rtf_window_ms = 1000;
// Stepping yields to the event loop after this long, and a simulation that cannot keep up skips the ticks beyond so
// many.
constexpr qint64 turn_ms = 20;
constexpr double most_ticks_owed = 5.0;

/// True if nobody who watches would see a difference: a body at rest on another trembles a little.
bool looksLike(const protocol::WorldObjects& some, const protocol::WorldObjects& others) {
    constexpr double least_m = 0.002;
    constexpr double least_rad = 0.01;
    return std::ranges::equal(some.objects, others.objects, [](const auto& a, const auto& b) {
        const Pose& from = a.object_in_map;
        const Pose& to = b.object_in_map;
        return a.name == b.name && a.size_m == b.size_m && (from.position_m - to.position_m).norm() < least_m &&
               from.rotation().angularDistance(to.rotation()) < least_rad;
    });
}

} // namespace

SimulatorServer::SimulatorServer(std::unique_ptr<sim::Simulation> simulation, QObject* parent)
    : QObject(parent)
    , simulation_(std::move(simulation))
    , tick_(simulation_->options().tick) {
    pace_timer_.setSingleShot(true);
    pace_timer_.setTimerType(Qt::PreciseTimer);
    connect(&pace_timer_, &QTimer::timeout, this, &SimulatorServer::advance);
    connect(&report_timer_, &QTimer::timeout, this, &SimulatorServer::report);
    connect(&server_, &QTcpServer::newConnection, this, &SimulatorServer::acceptAll);
    connect(&server_, &GuardedServer::turnedAway, this, &SimulatorServer::logged);
    wall_.start();
}

SimulatorServer::~SimulatorServer() {
    for (const auto& [client, socket] : sockets_)
        socket->disconnect(this);
}

Result<quint16> SimulatorServer::listen(quint16 port) {
    const Result<quint16> listened = server_.open(port, "--port");
    if (listened) {
        report_timer_.start(report_interval_ms);
        advance();
    }
    return listened;
}

void SimulatorServer::setPace(Pace pace, double factor) {
    pace_ = pace;
    factor_ = std::isfinite(factor) && factor > 0.0 ? factor : 1.0;
    owed_ = Seconds{0.0};
    held_up_ = {};
    steps_asked_ = 0;
    samples_.clear();
    last_advance_ms_ = wall_.elapsed();
    advance();
    report();
}

void SimulatorServer::stepOnce() {
    if (pace_ != Pace::Paused)
        return;
    ++steps_asked_;
    advance();
}

void SimulatorServer::addFaults(const std::vector<sim::Fault>& faults, bool from_now) {
    for (sim::Fault fault : faults) {
        if (from_now) // Rounded to the millisecond for readability.
            fault.from = Seconds{std::round((fault.from + simulation_->now()).count() * 1e3) / 1e3};
        simulation_->addFault(fault);
    }
    emit faultsChanged(simulation_->faults());
}

void SimulatorServer::endFault(int id) {
    simulation_->endFault(id);
    emit faultsChanged(simulation_->faults());
    advance(); // Time may have waited for a client that the fault had silenced.
}

void SimulatorServer::letOrphansGo() {
    simulation_->letOrphansGo();
    advance();
}

void SimulatorServer::publishFaults() {
    const std::vector<sim::FaultStatus> news = simulation_->takeFaultNews();
    for (const sim::FaultStatus& one : news)
        emit faultTurned(
            QString::fromStdString(fixed((simulation_->now() - tick_).count(), 1) + " s: " + sim::sentenceOf(one)));
    if (!news.empty())
        emit faultsChanged(simulation_->faults());
}

void SimulatorServer::acceptAll() {
    while (QTcpSocket* const socket = server_.nextPendingConnection())
        accept(socket);
}

void SimulatorServer::accept(QTcpSocket* socket) {
    socket->setParent(this);
    socket->setSocketOption(QAbstractSocket::LowDelayOption, 1);
    const sim::ClientId client = simulation_->connect();
    sockets_[client] = socket;
    connect(socket, &QTcpSocket::readyRead, this, [=, this] { readFrom(socket, client); });
    // Queued, because writing to a client that has disconnected emits this in the middle of flush(), which iterates
    // over the sockets.
    connect(
        socket, &QTcpSocket::disconnected, this, [=, this] { forget(socket, client); }, Qt::QueuedConnection);
    emit logged(tr("client %1: connected").arg(client.value));
    flush();
}

void SimulatorServer::readFrom(QTcpSocket* socket, sim::ClientId client) {
    const QByteArray bytes = socket->readAll();
    simulation_->receive(client, {bytes.constData(), static_cast<std::size_t>(bytes.size())});
    publishLog();
    flush();
    advance();
}

void SimulatorServer::forget(QTcpSocket* socket, sim::ClientId client) {
    if (sockets_.erase(client) > 0) // Otherwise a fault has cut it off.
        simulation_->disconnect(client);
    socket->deleteLater();
    emit logged(tr("client %1: gone").arg(client.value));
    advance(); // The others may have been waiting for its STEP.
}

void SimulatorServer::advance() {
    if (!server_.isListening())
        return;
    switch (pace_) {
    case Pace::Paused:
        for (; steps_asked_ > 0 && simulation_->readyToStep(); --steps_asked_)
            tick();
        return;
    case Pace::Fast:
        return advanceFast();
    case Pace::Factor:
        return advanceByClock();
    }
}

void SimulatorServer::advanceFast() {
    const qint64 end_ms = wall_.elapsed() + turn_ms;
    while (!simulation_->idle() && simulation_->readyToStep()) {
        tick();
        // Without lockstep, the clients must be able to read and to send commands between ticks.
        if (!simulation_->hasLockstepClients() || wall_.elapsed() > end_ms)
            return pace_timer_.start(0);
    }
}

void SimulatorServer::advanceByClock() {
    const qint64 now_ms = wall_.elapsed();
    if (time_begins_with_robots_ && simulation_->idle()) {
        last_advance_ms_ = now_ms;
        return; // The line that asks for a robot calls advance() again.
    }
    owed_ += factor_ * Seconds{static_cast<double>(std::exchange(last_advance_ms_, now_ms) - now_ms) / -1000.0};
    while (owed_ >= tick_ && simulation_->readyToStep() && wall_.elapsed() - now_ms < turn_ms) {
        tick();
        owed_ -= tick_;
    }
    // While waiting for a STEP at most one tick is owed, so that no second one follows right after the STEP's own.
    const bool waiting = !simulation_->readyToStep();
    owed_ = std::min(owed_, (waiting ? 1.0 : most_ticks_owed) * tick_);
    if (!waiting || owed_ < tick_)
        pace_timer_.start(static_cast<int>(std::ceil(std::max(0.0, (tick_ - owed_).count()) / factor_ * 1000.0)));
}

void SimulatorServer::tick() {
    simulation_->step();
    held_up_ = {};
    publishLog();
    publishFaults();
    flush();
    for (const std::string& name : simulation_->takeVanished())
        emit robotVanished(QString::fromStdString(name));
    for (const std::string& name : simulation_->takeSilenced())
        emit robotSilenced(QString::fromStdString(name));
    for (const sim::ClientId client : simulation_->takeCut())
        if (const auto found = sockets_.find(client); found != sockets_.end()) {
            QTcpSocket* const socket = found->second;
            sockets_.erase(found);
            // Its robot goes in this tick: nobody knows how many more are made until the event loop's next turn.
            simulation_->disconnect(client);
            socket->abort(); // A fault; to the client it looks like a server that has died.
        }
    emit ticked();
}

void SimulatorServer::flush() {
    for (const auto& [client, socket] : sockets_) {
        const std::string bytes = simulation_->takeOutput(client);
        if (bytes.empty() || socket->state() != QAbstractSocket::ConnectedState)
            continue; // A disconnected client is removed in the event loop's next turn.
        socket->write(bytes.data(), static_cast<qint64>(bytes.size()));
        socket->flush();
        if (socket->bytesToWrite() > unread_limit_bytes_) {
            emit logged(tr("client %1: dropped because it does not read; %2 MiB wait for it")
                            .arg(client.value)
                            .arg(static_cast<double>(socket->bytesToWrite()) / (1 << 20), 0, 'f', 1));
            socket->abort();
        }
    }
}

void SimulatorServer::publishLog() {
    for (const std::string& sentence : simulation_->takeLog())
        emit logged(QString::fromStdString(sentence));
    for (const sim::RefusedObject& object : simulation_->takeRefused())
        emit objectRefused(QString::fromStdString(object.name), QString::fromStdString(object.reason));
}

SimulatorFigures SimulatorServer::figures() const {
    SimulatorFigures figures{simulation_->now(), 0.0, static_cast<int>(sockets_.size()), pace_, factor_};
    if (samples_.size() >= 2) {
        const Sample& first = samples_.front();
        const Sample& last = samples_.back();
        const double wall_s = static_cast<double>(last.wall_ms - first.wall_ms) / 1000.0;
        figures.real_time_factor = wall_s > 0.0 ? (last.now - first.now).count() / wall_s : 0.0;
    }
    return figures;
}

void SimulatorServer::watchLockstep() {
    // If this thread itself was held up (a debugger, a laptop asleep), the clients could not be heard.
    const qint64 since_ms =
        std::min<qint64>(wall_.elapsed() - std::exchange(last_watch_ms_, wall_.elapsed()), 2 * report_interval_ms);
    if (pace_ == Pace::Paused || sockets_.size() < 2 || simulation_->readyToStep()) {
        held_up_ = {};
        return;
    }
    held_up_ += std::chrono::milliseconds(since_ms);
    if (held_up_ < lockstep_patience_)
        return;
    for (const sim::ClientId client : simulation_->awaited()) {
        simulation_->releaseFromLockstep(client);
        emit logged(tr("client %1: taken out of lockstep because it has sent no STEP for %2 s while others waited; "
                       "LOCKSTEP {On true} puts it back %3")
                        .arg(client.value)
                        .arg(static_cast<double>(held_up_.count()) / 1000.0, 0, 'f', 1)
                        .arg(simulation_->mayStep(client) ? tr("once") : tr("no more")));
    }
    held_up_ = {};
    flush();
    advance();
}

void SimulatorServer::report() {
    watchLockstep();
    samples_.push_back({wall_.elapsed(), simulation_->now()});
    while (samples_.size() > 2 && samples_.back().wall_ms - samples_[1].wall_ms >= rtf_window_ms)
        samples_.pop_front();
    emit figuresChanged(figures());
    emit robotsChanged(simulation_->robots());
    if (const protocol::WorldObjects objects = simulation_->objects(); !looksLike(objects, objects_told_))
        emit objectsChanged(objects_told_ = objects);
    if (const std::vector<sim::TraceMark> marks = simulation_->traceMarksSince(marks_told_); !marks.empty())
        emit marksLeft(marks);
    marks_told_ = simulation_->traceMarksMade();
}

} // namespace usar::server
