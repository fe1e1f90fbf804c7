// A robot of the simulator as the server sees it: it obeys, moves, measures and answers.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/protocol/command.h"
#include "core/protocol/info_message.h"
#include "core/sim/physics.h"
#include "core/sim/ray_caster.h"

namespace usar::sim {

/// Where robots live. All of it outlives them.
struct RobotSurroundings {
    const World& world;
    const RayCaster& caster;
    Physics& physics;
};

struct RobotOptions {
    Pose base_in_map;
    std::uint64_t seed = 1;
    std::uint64_t number = 0; ///< of the spawn: each robot has random streams of its own
    Seconds battery_life{1200.0};
    Seconds scan_interval{0.2};
    bool noise = true;
};

/// What a viewer other than the wire may know of a robot.
struct RobotFigures {
    Pose base_in_map;
    Vec3 velocity_in_map_m_s = Vec3::Zero();
    bool broken = false;
    int collisions = 0;
    double distance_m = 0.0;
};

class Robot {
public:
    virtual ~Robot() = default;

    /// A driving command; those of other vehicles are ignored.
    virtual void obey(const protocol::Command& command) = 0;
    virtual void beforeStep(Seconds dt) = 0;
    virtual void afterStep(Seconds dt) = 0;

    /// The lines of a tick in UT2004's order (usarsim-protocol 9.1). The first tick brings only what needs no history.
    virtual void measure(Seconds now, bool first, std::vector<protocol::InfoMessage>& out) = 0;
    /// With an empty battery a robot neither obeys nor answers.
    virtual bool alive() const = 0;
    virtual protocol::GeometryInfo geometry(const std::string& type, const std::string& name) const = 0;
    virtual protocol::ConfigurationInfo configuration(const std::string& type, const std::string& name) const = 0;
    virtual bool set(const protocol::SetInsPose& wanted) = 0;

    virtual RobotFigures figures() const = 0;
};

/// Spawns by class name, with or without its package ("USARBot.AirRobot"), in any case. Fails for unknown classes and
/// where there is no room.
Result<std::unique_ptr<Robot>> spawnRobot(std::string_view class_name, const RobotSurroundings& surroundings,
                                          const RobotOptions& options);

} // namespace usar::sim
