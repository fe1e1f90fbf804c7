// Private implementation of a Simulation; for its own source files only.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/sim/camera/scene_capture.h"
#include "core/sim/client_session.h"
#include "core/sim/faults/fault_schedule.h"
#include "core/sim/physics/physics.h"
#include "core/sim/physics/scene.h"
#include "core/sim/prepared_world.h"
#include "core/sim/rays/ray_caster.h"
#include "core/sim/robots/robot.h"
#include "core/sim/simulation.h"
#include "core/sim/world_controller.h"

namespace usar::sim {

/// Inputs are recorded up to this size in total; beyond it the run can no longer be saved as a snapshot.
inline constexpr std::size_t most_journal_bytes = std::size_t(256) << 20;

struct Simulation::State {
    State(PreparedWorld prepared, const SimulationOptions& options_)
        : still(prepared.takeStill())
        , world(still->world)
        , options(options_)
        , physics(prepared.takePhysics())
        , caster(still->caster)
        , scene(makeScene(world, *physics))
        , controller(world, *physics, scene)
        , faults(options.seed) {
        for (const Fault& fault : options.faults)
            faults.add(fault);
    }

    /// Adds a sentence for takeLog(), with control bytes made visible. Of a client that causes too many, the rest is
    /// counted only.
    void log(ClientId client, const std::string& sentence);
    /// Adds a sentence with the number of those that were left out, if any.
    void tellLeftOut(ClientId client);
    /// Obeys a CONTROL. Returns what to log if that is impossible; a refused creation is kept for takeRefused()
    /// instead.
    std::optional<std::string> control(ClientId client, const protocol::Command& command);
    /// Returns nullptr if the robot cannot be spawned. One sentence in the log says so or says where it is, and `why`
    /// it has its name, if that is not the wanted one.
    std::unique_ptr<Robot> spawn(ClientId client, const protocol::Init& init, const std::string& why);
    /// The same for a base station.
    std::optional<Pose> stationAt(ClientId client, const protocol::Init& init, const std::string& why);
    /// The wanted name, or a new one and the reason for it if there is none or if another robot or station has it, as
    /// the game's engine does with the names of its bots (UnrealEngine 2, DeathMatch.ChangeName).
    std::pair<std::string, std::string> nameOf(ClientId client, const protocol::Init& init) const;
    /// Names the robot or thing whose middle is nearest to the point, "robot 'R1'"; leaves out the robot of `client`.
    std::string nearestThing(ClientId client, const Vec3& point_in_map_m) const;
    /// Why no robot can start there; nullopt if it may be tried.
    std::optional<std::string> refusalOf(const Pose& start_in_map) const;
    /// The start that INIT asks for. An unknown name is logged and gives the command's fallback or the map's origin.
    Pose startOf(ClientId client, const protocol::Init& init);
    /// Returns false if there is no such camera, or no such viewer to detach.
    bool attachCamera(const protocol::Command& command);
    /// Left and top edge, in pixels, of a robot's camera in the window (windowPicture) while it shows all cameras: two
    /// beside each other and two below them. Of more than four, the others are below the window.
    std::pair<int, int> placeInWindow(ClientId client, std::string_view camera) const;
    std::string knownClasses() const;
    /// Obeys all clients' commands that are due, in the order of their connections.
    void obeyAll();
    /// Advances the fault schedule and applies what has changed.
    void followFaults();
    /// Tells a session of its active faults, and logs those that have no effect on its robot.
    void setFaults(ClientId client, ClientSession& session);
    /// Runs the physics steps of one tick.
    void move();
    /// Refreshes the scene, and writes each client's lines and its robot's trace mark.
    void reportAll();
    /// Keeps the figures of a robot that is about to be removed, for lastGone().
    void rememberFigures(ClientId client, const ClientSession& session);
    /// Records an input of the run.
    void keep(JournalEntry::Kind kind, std::uint32_t client = 0, std::string_view bytes = {});
    /// Gives a robot that waits for a client to this one if its INIT names that robot; returns whether it did.
    bool adopt(ClientId client, ClientSession& session);
    /// Digest of everything that must come out the same when the run is replayed.
    std::uint64_t digest() const;

    // The order matters: physics and ray caster refer to the world, and sessions hold robots whose bodies are in the
    // physics.
    std::shared_ptr<const StillWorld> still;
    const World& world;
    SimulationOptions options;
    std::unique_ptr<Physics> physics;
    const RayCaster& caster;
    Scene scene;
    WorldController controller;
    FaultSchedule faults;
    std::map<ClientId, ClientSession> sessions;
    std::vector<ClientId> cut;                    ///< for takeCut()
    std::vector<FaultStatus> fault_news;          ///< for takeFaultNews()
    std::map<std::string, CameraChoice> attached; ///< each viewer's camera, by the viewer's address
    std::optional<Viewports> viewports;
    ClientId last_client;
    std::uint64_t spawned = 0;    ///< robots ever spawned
    std::uint64_t ticks = 0;      ///< message ticks made
    std::uint64_t marks_made = 0; ///< TRACE marks ever made
    /// Catalogs that learn() replaced; spawned robots may still refer to them.
    std::vector<std::shared_ptr<const RobotCatalog>> former_robots;
    std::vector<JournalEntry> journal;
    std::size_t journal_bytes = 0;
    std::vector<std::string> sentences; ///< for takeLog()
    /// What a client may still cause to be logged.
    struct Chatter {
        double allowance = 50.0; ///< sentences
        Seconds at{0.0};         ///< when it was reckoned
        std::size_t left_out = 0;
    };
    std::map<ClientId, Chatter> chatters;
    std::optional<RobotTruth> last_gone;
    std::vector<std::string> vanished;  ///< for takeVanished()
    std::vector<std::string> silenced;  ///< for takeSilenced()
    std::vector<RefusedObject> refused; ///< for takeRefused()

    Seconds now() const { return static_cast<double>(ticks) * options.tick; }
};

} // namespace usar::sim
