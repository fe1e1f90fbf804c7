// The embedded USARSim server without its sockets: bytes in, bytes out, time by steps.
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
#include "core/base/result.h"
#include "core/protocol/dialect.h"
#include "core/sim/camera/camera_scene.h"
#include "core/sim/faults/fault_schedule.h"
#include "core/sim/radio.h"
#include "core/sim/robots/height_watch.h"
#include "core/sim/robots/robot_model.h"
#include "core/sim/snapshot.h"
#include "core/sim/world.h"

namespace usar::sim {

/// A day: the thesis (4.1) sets the server's battery very high, for a server cannot charge, and lets the client count.
inline constexpr Seconds survey_battery_life{86400.0};

struct SimulationOptions {
    std::uint64_t seed = 1;
    /// How the server speaks. UDK answers each question at once, sends each sensor in a line of its own and usually
    /// ticks each 0.1 s (usarsim-protocol 7).
    protocol::Dialect profile = protocol::Dialect::Ut2004;
    Seconds tick{0.2};                     ///< UT2004 message tick
    int physics_steps_per_tick = 50;       ///< 250 Hz
    std::optional<Seconds> battery_life{}; ///< instead of what each robot's file says
    bool noise = true;
    std::shared_ptr<const RobotCatalog> robots{}; ///< what can be spawned
    std::vector<Fault> faults{};                  ///< on request
    std::string world_source{};                   ///< name or folder that the world came from, for snapshots
    RadioParameters radio{};
};

/// Identifies one connection.
struct ClientId {
    std::uint32_t value = 0;
    auto operator<=>(const ClientId&) const = default;
};

/// What a viewer other than the wire may know of a robot (tests, scoring, figures); behaviors never see it.
struct RobotTruth {
    ClientId client;
    std::string name;
    Pose base_in_map;
    Vec3 velocity_in_map_m_s = Vec3::Zero();
    bool broken = false;
    int collisions = 0;
    double distance_m = 0.0;               ///< true path length
    Seconds longest_stay{0.0};             ///< see StayWatch
    int falls = 0;                         ///< see FallWatch
    int touches = 0;                       ///< of things that can be pushed; see TouchWatch
    std::optional<Seconds> first_touch{};  ///< since the spawn
    std::optional<HeightFigures> height{}; ///< of what dives, since it went under
};

struct TraceMark;

/// One world, its robots and their connections. Single-threaded; the same seed and the same bytes at the same ticks
/// give the same bytes. Owned by whoever serves it.
class Simulation {
public:
    static Result<std::unique_ptr<Simulation>> make(World world, SimulationOptions options = {});
    ~Simulation();

    ClientId connect();
    void disconnect(ClientId client);
    /// Bytes from the client, in any chunks; obeyed at the next step, but GETSTARTPOSES and LOCKSTEP at once.
    void receive(ClientId client, std::string_view bytes);
    /// Bytes for the client since the last call.
    std::string takeOutput(ClientId client);

    /// This moment, to go on from. Fails where the run has been told more than can be kept (256 MiB).
    Result<Snapshot> snapshot() const;
    /// So much of a run has been lived through again, of so much; false gives it up.
    using ResumeWatch = std::function<bool(Seconds done, Seconds whole)>;
    /// Goes on where the snapshot was taken, with this world and these robots; fails where they are not those of the
    /// run any more, or where `watch`, which is asked each tick, gives it up. Its robots wait, and time with them, each
    /// for a client that says INIT with its name; one that nobody wants is let go by `releaseFromLockstep`.
    static Result<std::unique_ptr<Simulation>> resume(World world, std::shared_ptr<const RobotCatalog> robots,
                                                      const Snapshot& snapshot, const ResumeWatch& watch = {});
    /// A robot that waits.
    struct Orphan {
        std::string class_name; ///< as INIT takes it
        std::string name;
        Pose base_in_map;
    };
    std::vector<Orphan> orphans() const;
    void letOrphansGo();

    /// One more class of robots can be spawned, or this one in the place of one of the same name. No input of the run:
    /// a snapshot is taken up with all its robots.
    void learn(RobotModel model);

    /// False while a lockstep client has not said STEP since the last tick.
    bool readyToStep() const;
    bool hasLockstepClients() const;
    /// The clients whose STEP is missing.
    std::vector<ClientId> awaited() const;
    /// For a client that has hung: it is told, and not waited for any more.
    void releaseFromLockstep(ClientId client);
    /// True while nothing would happen but the passing of time: no robot and no command that waits.
    bool idle() const;
    /// One message tick: physics, sensors, lines for every client.
    void step();

    /// From the next tick on, or when its time comes. The number is for `endFault`, which says whether there was
    /// something to end.
    int addFault(const Fault& fault);
    bool endFault(int id);
    const std::vector<FaultStatus>& faults() const;
    /// Those that have begun or ended since the last call.
    std::vector<FaultStatus> takeFaultNews();
    /// Clients whose connection a fault has cut: whoever serves them hangs up.
    std::vector<ClientId> takeCut();

    Seconds now() const;
    const SimulationOptions& options() const;
    const World& world() const;
    /// What cameras can see now, for pictures in any thread.
    CameraScene cameraScene() const;
    std::vector<RobotTruth> robots() const;
    /// Of all robots and base stations, in the order of their connections.
    std::vector<RadioStation> radios() const;
    /// All of them, also those that weaken a radio no further.
    int obstaclesBetween(const Vec3& a_in_map_m, const Vec3& b_in_map_m) const;
    /// Between two antennas, as they stand now.
    double radioStrength_dbm(const RadioStation& a, const RadioStation& b) const;
    /// What robots under TRACE left behind, oldest first; of all clients.
    const std::vector<TraceMark>& traceMarks() const;
    std::uint64_t traceMarksMade() const;
    /// Those that came after the first so many were made, as far as they are kept.
    std::vector<TraceMark> traceMarksSince(std::uint64_t made) const;
    std::size_t clientCount() const;
    /// What was ignored, refused or mended since the last call: one sentence each, for the server's log.
    std::vector<std::string> takeLog();

private:
    struct State;
    void apply(const JournalEntry& entry);
    explicit Simulation(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

} // namespace usar::sim
