// The embedded simulator for programs without a window.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <QObject>
#include <QString>
#include <QThread>

#include "core/base/result.h"
#include "core/link/in_process_socket.h"
#include "core/server/simulator_server.h"
#include "core/sim/rays/ray_caster.h"
#include "core/sim/simulation.h"
#include "core/sim/world/free_space.h"

namespace usar::server {

/// Options of a headless simulator.
struct HeadlessSpec {
    std::uint64_t seed = 1;
    std::optional<double> speed_x{}; ///< simulated seconds per real second; absent: as fast as possible
    std::vector<sim::Fault> faults{};
    /// Life of every robot's battery; nullopt: as its file says.
    std::optional<Seconds> battery_life = sim::survey_battery_life;
    /// The simulator has a thread of its own. Without one it costs least if its client thinks in that thread, too,
    /// because nobody has to be woken up, which takes longer than a tick.
    bool own_thread = true;
};

/// Serves one world on a free loopback port, or in memory, until it is destroyed, from a thread of its own or from the
/// main thread's event loop; simulated time begins with the first robot. The truth and the figures that it gives out
/// are for scoring only; behaviors see only what the server sends. Belongs to the main thread.
class HeadlessSimulator {
public:
    /// Loads a world by name or folder and serves it. An unknown world is an error that lists the known ones.
    static Result<std::unique_ptr<HeadlessSimulator>> start(const QString& world, const HeadlessSpec& spec);
    static Result<std::unique_ptr<HeadlessSimulator>> serve(sim::World world, const HeadlessSpec& spec);
    static Result<std::unique_ptr<HeadlessSimulator>> serve(sim::PreparedWorld world, const HeadlessSpec& spec);
    /// Waits for the simulator's thread to end.
    ~HeadlessSimulator();

    quint16 port() const { return port_; }
    /// Takes clients of this thread without TCP, and may outlive the simulator, which then hangs up; empty if the
    /// simulator has a thread of its own.
    link::InProcessServer inProcess();
    /// Extent of the world in meters, map frame.
    Rectangle extent() const;
    double dryAbove_m() const; ///< see sim::dryAbove_m
    /// True height in meters, z up, at a point of the map frame: of what is seen from above (ground, crown or roof),
    /// and of the bare terrain.
    double surface_m(const Vec2& point_in_map_m) const { return simulation_->caster().surface_m(point_in_map_m); }
    double ground_m(const Vec2& point_in_map_m) const { return simulation_->world().terrain.height_m(point_in_map_m); }
    /// Says what a flight can reach of the area; see sim::reachFrom.
    ReachMap reach(const FlightLimits& flight, const Rectangle& area_in_map) const {
        return sim::reachFrom(simulation_->world(), flight, area_in_map);
    }
    /// `tell` is called in the thread of `context` with a sentence when a fault begins or ends.
    void onFault(QObject* context, const std::function<void(const QString&)>& tell);
    /// `tell` is called in the thread of `context` with the name of a robot that a fault has removed.
    void onVanished(QObject* context, const std::function<void(const QString&)>& tell);
    /// The same for a robot whose client hears nothing more; see sim::Simulation::takeSilenced.
    void onSilenced(QObject* context, const std::function<void(const QString&)>& tell);
    /// Truth about the first robot, or, if there is none now, about the one that left last, as it was then: a
    /// connection that breaks must not take the figures along. Waits for the simulator's thread.
    std::optional<sim::RobotTruth> firstRobot() const;

private:
    HeadlessSimulator() = default;
    /// Makes the call in the simulator's thread, and waits for it.
    void run(const std::function<void()>& call) const;

    QThread thread_;
    QObject* worker_ = new QObject; ///< belongs to thread_ if that runs, owns the server, and is deleted there
    SimulatorServer* server_ = nullptr;
    /// Owned by the server and used in its thread only, except for the world and its ray caster, which do not change.
    const sim::Simulation* simulation_ = nullptr;
    quint16 port_ = 0;
};

} // namespace usar::server
