// The program without its window: a fleet of robots, and the embedded simulator that may host them.
#pragma once

#include <vector>

#include "core/mission/edits/edit_history.h"
#include "core/mission/fleet/fleet.h"
#include "core/mission/fleet/fleet_questions.h"
#include "core/mission/fleet/known_ground.h"
#include "core/server/embedded/simulator_host.h"
#include "core/server/embedded/window_options.h"

namespace usar::app {

using mission::missionKey;
using mission::Robot;
using mission::RobotView;
using mission::StartedBehavior;
using Options = server::WindowOptions;
using server::ServerTarget;

/// A fleet that can start an embedded simulator, which runs in a separate thread. Belongs to the GUI thread and never
/// blocks it.
class MissionControl : public mission::Fleet {
    Q_OBJECT
public:
    explicit MissionControl(QObject* parent = nullptr);
    ~MissionControl() override;

    /// Calls `disconnectFromServer`, then starts the embedded simulator or connects to the server.
    void connectTo(const ServerTarget& target);
    server::SimulatorHost& simulator() { return simulator_; }
    /// The history of the edits in all parts of the window.
    mission::EditHistory& history() { return history_; }
    const ServerTarget& server() const { return target_; }
    /// The embedded simulator's world; empty on a real server.
    const server::WorldPicture& world() const { return world_; }
    /// Returns the robots that plugins can drive, followed by the embedded simulator's other robots, which can only be
    /// driven by commands.
    std::vector<agent::RobotDescription> robotsToSpawn() const;
    /// Height of the ground, as far as it is known (mission::knownGround_m).
    double ground_m(const Vec2& at_m, const Robot* scanning) const {
        return mission::knownGround_m(at_m, world_.terrainHeight(), scanning, startPoses());
    }
    /// Names of all robots on the server; replays are left out.
    QStringList liveNames() const { return mission::liveNames(robots()); }
    /// True if a behavior of ours runs on any robot.
    bool anyRunning() const { return mission::anyRunning(robots()); }
    /// Sets the pace of the embedded simulator; a real server's time cannot be controlled.
    void setPace(server::Pace pace, double factor);
    /// Injects faults into the embedded simulator; their times count from now. An error names the first text that is
    /// not a fault.
    Result<void> addFaults(const QStringList& texts);

signals:
    void worldKnown(const usar::server::WorldPicture& world);
    /// The result of `robotsToSpawn` has changed.
    void classesChanged();

private:
    void enter(quint16 port, const server::WorldPicture& world, const std::vector<sim::Simulation::Orphan>& waiting);
    void leave();
    /// Gives the spare connection to the next waiting robot of a snapshot.
    void goOnWithNext();

    mission::EditHistory history_;
    server::SimulatorHost simulator_;
    ServerTarget target_;
    server::WorldPicture world_;                   ///< the embedded simulator's; empty on a real server
    std::vector<sim::Simulation::Orphan> waiting_; ///< robots of a snapshot that each need a connection
};

} // namespace usar::app
