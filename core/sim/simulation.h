// The embedded USARSim server without its sockets: bytes in, bytes out; only step() advances time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/clock.h"
#include "core/base/id.h"
#include "core/base/result.h"
#include "core/protocol/info/world_objects.h"
#include "core/sim/camera/camera_scene.h"
#include "core/sim/faults/fault_schedule.h"
#include "core/sim/prepared_world.h"
#include "core/sim/radio.h"
#include "core/sim/rays/ray_caster.h"
#include "core/sim/robots/robot_figures.h"
#include "core/sim/robots/robot_model.h"
#include "core/sim/snapshot.h"
#include "core/sim/world/world.h"

namespace usar::sim {

/// A week. The thesis (4.1) sets the server's battery life very high, because a server cannot recharge a robot, and
/// lets the client keep track of the charge.
inline constexpr Seconds survey_battery_life{604800.0};

/// The world goes on for so long without a client that a fault has silenced for good.
inline constexpr Seconds silence_limit{30.0};

/// Identifies one connection of a Simulation, from 1; never reused.
using ClientId = Id<struct ClientTag, 0U>;

/// Ground truth about a robot for viewers other than the wire (tests, scoring, figures).
struct RobotTruth : RobotFigures {
    ClientId client{};
    std::string name{};
};

/// A creation of an object that was refused. `reason` is part of a sentence and says what helps; `name` may be empty.
struct RefusedObject {
    std::string name;
    std::string reason;
};

struct TraceMark;

/// One world, its robots and their connections. Single-threaded and deterministic: the same seed and the same bytes at
/// the same ticks give the same output. Owned by the server that passes the bytes in and out.
class Simulation {
public:
    /// Fails if there is nothing to stand on, or if tick, physics steps or battery life are not positive.
    static Result<std::unique_ptr<Simulation>> make(World world, SimulationOptions options = {});
    static Result<std::unique_ptr<Simulation>> make(PreparedWorld world, SimulationOptions options = {});
    ~Simulation();

    ClientId connect();               ///< its first output is the greeting
    void disconnect(ClientId client); ///< removes its robot and its non-permanent objects
    /// Takes bytes from the client, in chunks of any size. Commands are obeyed at the next step, except GETSTARTPOSES
    /// and LOCKSTEP, which are obeyed at once.
    void receive(ClientId client, std::string_view bytes);
    std::string takeOutput(ClientId client); ///< the bytes for the client since the last call

    /// The current state, to be resumed later. Fails if the run's inputs exceed 256 MiB.
    Result<Snapshot> snapshot() const;
    /// Progress of `resume`: simulated time replayed so far, and in total. Returns false to cancel.
    using ResumeWatch = std::function<bool(Seconds done, Seconds whole)>;
    /// Continues where the snapshot was taken, with this world and these robots. Fails if they are no longer those of
    /// the run, or if `watch`, which is called at each tick, cancels. Each robot then waits, and time stands still,
    /// until a client sends INIT with its name or `releaseFromLockstep` removes it.
    static Result<std::unique_ptr<Simulation>> resume(World world, std::shared_ptr<const RobotCatalog> robots,
                                                      const Snapshot& snapshot, const ResumeWatch& watch = {});
    /// A resumed robot that waits for a client.
    struct Orphan {
        std::string class_name; ///< as INIT takes it
        std::string name;
        Pose base_in_map;
    };
    std::vector<Orphan> orphans() const;
    void letOrphansGo(); ///< removes them all

    /// Adds a robot class that can be spawned, or replaces the one of the same name. This is not recorded as an input:
    /// `resume` needs a catalog that already contains all robots of the run.
    void learn(RobotModel model);

    /// False while an orphan waits or a lockstep client has not sent STEP since the last tick.
    bool readyToStep() const;
    bool hasLockstepClients() const;
    /// The clients that `readyToStep` waits for; an orphan is listed by its former client.
    std::vector<ClientId> awaited() const;
    /// Stops waiting for a client that hangs, and tells it so; removes an orphan. After the second time it gets no
    /// lockstep again.
    void releaseFromLockstep(ClientId client);
    /// False if the client has lost the right to lockstep, or is not there.
    bool mayStep(ClientId client) const;
    /// True while only time would pass: no robot, no world controller and no waiting command.
    bool idle() const;
    void step(); ///< simulates one message tick: commands, faults, physics, sensors, output for every client

    /// Schedules a fault, to act from the next tick or from its own start time. Returns the number for `endFault`,
    /// which returns false if there is no such fault or it is already over.
    int addFault(const Fault& fault);
    bool endFault(int id);
    const std::vector<FaultStatus>& faults() const;
    std::vector<FaultStatus> takeFaultNews(); ///< those that have begun or ended since the last call
    std::vector<ClientId> takeCut();          ///< those cut by a fault since the last call; the server must close them

    Seconds now() const;
    const SimulationOptions& options() const;
    const World& world() const;
    /// Casts rays at the still world; other threads may share it.
    const RayCaster& caster() const;
    CameraScene cameraScene() const; ///< a value that any thread can render
    std::vector<RobotTruth> robots() const;
    std::optional<RobotTruth> lastGone() const; ///< the robot that was removed last, as it was then
    protocol::WorldObjects objects() const;     ///< where the movable ones are now
    std::vector<RadioStation> radios() const;   ///< those of all robots and base stations, in the order of connection
    /// Counts all obstacles, even those beyond the number that weakens a radio.
    int obstaclesBetween(const Vec3& a_in_map_m, const Vec3& b_in_map_m) const;
    /// Received signal strength between two antennas, with the obstacles of the still world.
    double radioStrength_dbm(const RadioStation& a, const RadioStation& b) const;
    std::uint64_t traceMarksMade() const; ///< ever, including dropped ones
    /// The marks after the first `made` ones, as far as they are still kept.
    std::vector<TraceMark> traceMarksSince(std::uint64_t made) const;
    std::size_t clientCount() const;
    std::vector<std::string> takeVanished(); ///< names of robots that a fault removed since the last call
    /// Names of robots whose client in lockstep hears nothing more, because its connection has been half open for
    /// `silence_limit` and will stay so. Time stands still for them then; otherwise the end of such a run would depend
    /// on how fast the simulation runs on while its client waits.
    std::vector<std::string> takeSilenced();
    std::vector<RefusedObject> takeRefused(); ///< since the last call, at most 1000; they are not in the log
    std::vector<std::string> takeLog();       ///< sentences for the server's log since the last call, at most 1000
    /// Logs how many sentences about each client were left out, for a server that ends while they are connected.
    void sumUpLog();

private:
    struct State;
    void apply(const JournalEntry& entry);
    explicit Simulation(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

} // namespace usar::sim
