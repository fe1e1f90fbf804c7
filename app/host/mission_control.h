// The program without its window: a fleet of robots, and the embedded simulator that they may live in.
#pragma once

#include <vector>

#include "core/mission/fleet/fleet.h"
#include "core/protocol/usual_values.h"
#include "core/server/embedded/simulator_host.h"

namespace usar::app {

using mission::missionKey;
using mission::Robot;
using mission::RobotView;
using mission::StartedBehavior;

/// Where robots live: in the simulator that comes with the program, or on a server.
struct ServerTarget {
    bool embedded = true;
    QString host = "127.0.0.1";
    quint16 port = protocol::usual_port::bot;
    server::SimulatorSpec simulator;
};

/// A fleet that can start a simulator of its own, in a thread of its own. Lives in the GUI thread and never waits in
/// it.
class MissionControl : public mission::Fleet {
    Q_OBJECT
public:
    explicit MissionControl(QObject* parent = nullptr);
    ~MissionControl() override;

    void connectTo(const ServerTarget& target);
    server::SimulatorHost& simulator() { return simulator_; }
    const ServerTarget& server() const { return target_; }
    /// The embedded simulator's world; empty on a real server.
    const server::WorldPicture& world() const { return world_; }
    /// What plugins can drive, and then what the embedded simulator has besides, which only commands drive.
    std::vector<agent::RobotDescription> robotsToSpawn() const;
    /// Of the embedded simulator; a real server's time cannot be steered.
    void setPace(server::Pace pace, double factor);
    /// In the embedded simulator, from now on. An error names the first text that is no fault.
    Result<void> addFaults(const QStringList& texts);

signals:
    void worldKnown(const usar::server::WorldPicture& world);
    /// Other robots can be spawned now.
    void classesChanged();

private:
    void wireSimulator();
    void enter(quint16 port, const server::WorldPicture& world, const std::vector<sim::Simulation::Orphan>& waiting);
    void leave();
    void learn(const QString& class_name, bool has_camera);
    /// The next robot of a snapshot gets the connection that is free.
    void goOnWithNext();

    server::SimulatorHost simulator_;
    ServerTarget target_;
    server::WorldPicture world_;                   ///< empty on a real server
    std::vector<sim::Simulation::Orphan> waiting_; ///< robots of a snapshot that want a connection each
};

} // namespace usar::app
