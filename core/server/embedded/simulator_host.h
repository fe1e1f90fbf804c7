// The embedded simulator in a thread of its own.
#pragma once

#include <optional>

#include <QImage>
#include <QObject>
#include <QThread>

#include "core/base/geometry.h"
#include "core/server/embedded/simulation_loader.h"
#include "core/server/embedded/world_picture.h"
#include "core/server/simulator_server.h"

namespace usar::server {

/// Starts, paces and stops the simulator. Lives in the GUI thread; loading and serving happen in its own thread.
class SimulatorHost : public QObject {
    Q_OBJECT
public:
    explicit SimulatorHost(QObject* parent = nullptr);
    ~SimulatorHost() override;

    /// Ends the one before, without waiting for it here. `ready` or `failed` follows.
    void start(const SimulatorSpec& spec);
    void stop();
    bool running() const { return server_ != nullptr; }

    void setPace(server::Pace pace, double factor);
    void stepOnce();
    /// Their times count from now.
    void addFaults(const std::vector<sim::Fault>& faults);
    void endFault(int id);
    /// `snapshotSaved` or `snapshotFailed` follows.
    void saveSnapshot(const QString& path);
    /// The class of a robot file can be spawned from now on: `robotLearned` or `robotRefused` follows.
    void learn(const QString& robot_file);
    /// Time goes on without the robots that wait since a snapshot was taken up.
    void letOrphansGo();

signals:
    /// `waiting` are the robots of a snapshot: each wants a connection that says INIT with its name.
    void ready(quint16 port, const usar::server::WorldPicture& world,
               const std::vector<usar::sim::Simulation::Orphan>& waiting);
    void snapshotSaved(const QString& path);
    void snapshotFailed(const QString& reason);
    /// One sentence with the mend.
    void failed(const QString& reason);
    void noted(const QString& sentence);
    /// A robot file that cannot be read; the others can be spawned.
    void robotRefused(const QString& sentence);
    void robotLearned(const QString& robot_file, const QString& class_name, bool has_camera);
    /// The wanted port belongs to another program; one sentence with the port that was taken instead.
    void movedPort(const QString& sentence);
    /// Before `ready`: where its further channels listen.
    void channelsOpened(const usar::server::ChannelPorts& ports);
    void figuresChanged(const usar::server::SimulatorFigures& figures);
    void faultsChanged(const std::vector<usar::sim::FaultStatus>& faults);
    void faultTurned(const QString& sentence);
    void robotsChanged(const std::vector<usar::sim::RobotTruth>& robots);
    void marksLeft(const std::vector<usar::sim::TraceMark>& marks);

private:
    void serve(const SimulatorSpec& spec, QObject* worker);
    void wire(const server::SimulatorServer& server);
    void launch(const SimulatorSpec& spec);
    void retire();

    QThread* thread_ = nullptr;                 ///< of the simulator that runs; deletes itself when it has ended
    QObject* worker_ = nullptr;                 ///< lives in thread_: context of what runs there
    server::SimulatorServer* server_ = nullptr; ///< lives in thread_, owned by worker_
    std::optional<SimulatorSpec> next_;         ///< starts when the one before has let go of its port
};

} // namespace usar::server
