// What a Simulation is made of; for its own files.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/sim/camera/scene_capture.h"
#include "core/sim/client_session.h"
#include "core/sim/faults/fault_schedule.h"
#include "core/sim/physics.h"
#include "core/sim/ray_caster.h"
#include "core/sim/robots/robot.h"
#include "core/sim/scene.h"
#include "core/sim/simulation.h"
#include "core/sim/world_controller.h"

namespace usar::sim {

/// What comes from outside is kept up to here.
inline constexpr std::size_t most_journal_bytes = std::size_t(256) << 20;

struct Simulation::State {
    State(World world_, const SimulationOptions& options_)
        : still(std::make_shared<const StillWorld>(std::move(world_)))
        , world(still->world)
        , options(options_)
        , physics(makePhysics(world))
        , caster(still->caster)
        , scene(makeScene(world, *physics))
        , controller(world, *physics, scene)
        , faults(options.seed) {
        for (const Fault& fault : options.faults)
            faults.add(fault);
    }

    void log(ClientId client, const std::string& sentence);
    std::unique_ptr<Robot> spawn(ClientId client, const protocol::Init& init);
    Pose startOf(ClientId client, const protocol::Init& init);
    bool attachCamera(const protocol::Command& command);
    std::string knownClasses() const;
    void obeyAll();
    void followFaults();
    void setFaults(ClientId client, ClientSession& session);
    bool vanishes(const ClientSession& session) const;
    void move();
    void reportAll();
    void keep(JournalEntry::Kind kind, std::uint32_t client = 0, std::string_view bytes = {});
    bool adopt(ClientId client, ClientSession& session);
    std::uint64_t digest() const;

    // In this order: physics and rays look into the world, sessions hold robots that live in the physics.
    std::shared_ptr<const StillWorld> still;
    const World& world;
    SimulationOptions options;
    std::unique_ptr<Physics> physics;
    const RayCaster& caster;
    Scene scene;
    WorldController controller;
    FaultSchedule faults;
    std::map<ClientId, ClientSession> sessions;
    std::vector<ClientId> cut;
    std::vector<FaultStatus> fault_news;
    std::map<std::string, CameraChoice> attached; ///< cameras, by the address of the viewer
    std::optional<Viewports> viewports;
    ClientId last_client;
    std::uint64_t spawned = 0;
    std::uint64_t ticks = 0;
    std::uint64_t marks_made = 0;                                   ///< of TRACE
    std::vector<std::shared_ptr<const RobotCatalog>> former_robots; ///< robots that are there may be of them
    std::vector<JournalEntry> journal;
    std::size_t journal_bytes = 0;
    std::vector<std::string> sentences;

    Seconds now() const { return static_cast<double>(ticks) * options.tick; }
};

} // namespace usar::sim
