// Runs the embedded simulator in a thread of its own.
#pragma once

#include <optional>

#include <QObject>
#include <QThread>

#include "core/server/embedded/simulation_loader.h"
#include "core/server/embedded/world_picture.h"
#include "core/server/simulator_server.h"

namespace usar::server {

/// Starts, paces and stops the simulator. Belongs to the GUI thread; loading and serving happen in the simulator's
/// thread, for which only the destructor waits. Some signals are emitted in that thread, so receivers need Qt's default
/// connection type. While no simulator is ready, calls other than start and stop are ignored.
class SimulatorHost : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;
    ~SimulatorHost() override;

    /// Stops a running simulator without waiting for its end, then starts this one. `ready` or `failed` follows.
    void start(const SimulatorSpec& spec);
    void stop();
    /// True from `ready` until the simulator is stopped or replaced.
    bool running() const { return server_ != nullptr; }

    /// `factor`: simulated seconds per real second, used with Pace::Factor.
    void setPace(Pace pace, double factor);
    /// While paused, makes one tick.
    void stepOnce();
    /// The faults' times are relative to now.
    void addFaults(const std::vector<sim::Fault>& faults);
    void endFault(int id);
    /// `snapshotSaved` or `snapshotFailed` follows.
    void saveSnapshot(const QString& path);
    /// Makes the class of a robot file available for spawning; `robotLearned` or `robotRefused` follows.
    void learn(const QString& robot_file);
    /// Removes the robots of a resumed snapshot that no client has claimed, so that time continues without them.
    void letOrphansGo();

signals:
    /// `waiting` are the robots of a resumed snapshot: time stands still until a connection has sent INIT with the name
    /// of each.
    void ready(quint16 port, const usar::server::WorldPicture& world,
               const std::vector<usar::sim::Simulation::Orphan>& waiting);
    void snapshotSaved(const QString& path);
    void snapshotFailed(const QString& reason);
    /// The simulator could not be started; `reason` contains the remedy.
    void failed(const QString& reason);
    /// A sentence of the simulator's log.
    void noted(const QString& sentence);
    /// A robot file cannot be read; the others can be spawned.
    void robotRefused(const QString& sentence);
    /// `class_name` is without package; `outlines` as in WorldPicture.
    void robotLearned(const QString& robot_file, const QString& class_name, bool has_camera,
                      const std::vector<usar::Outline>& outlines);
    /// A wanted port is in use by another program, and the sentence names the port that is used instead, if any; or the
    /// simulator is open to other machines.
    void movedPort(const QString& sentence);
    /// Emitted before `ready`, with the ports on which the other channels listen.
    void channelsOpened(const usar::server::ChannelPorts& ports);
    // The following signals are those of SimulatorServer.
    void figuresChanged(const usar::server::SimulatorFigures& figures);
    void faultsChanged(const std::vector<usar::sim::FaultStatus>& faults);
    void faultTurned(const QString& sentence);
    void objectRefused(const QString& name, const QString& reason);
    void robotsChanged(const std::vector<usar::sim::RobotTruth>& robots);
    void objectsChanged(const usar::protocol::WorldObjects& objects);
    void marksLeft(const std::vector<usar::sim::TraceMark>& marks);

private:
    /// Loads and serves; runs in the simulator's thread.
    void serve(const SimulatorSpec& spec, QObject* worker);
    void wire(const SimulatorServer& server);
    /// Starts a new thread for the simulator. There must be none.
    void launch(const SimulatorSpec& spec);
    void retire();
    template <class Call>
    void post(Call call);

    QThread* thread_ = nullptr;         ///< the simulator's thread; deleted when it has ended
    QObject* worker_ = nullptr;         ///< context object of the calls in thread_; null: none runs
    SimulatorServer* server_ = nullptr; ///< belongs to thread_, owned by worker_
    std::optional<SimulatorSpec> next_; ///< to be started when the previous thread has ended
};

} // namespace usar::server
