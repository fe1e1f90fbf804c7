// Publishes the marks on the height map (thesis figure 4.4) and the values that the map and the status strip show.
#pragma once

#include <optional>

#include "core/agent/command_port.h"
#include "robots/airrobot/flight/evasion.h"
#include "robots/airrobot/flight/senses.h"
#include "robots/airrobot/settings.h"

namespace usar::airrobot {

/// How the robot leans on average, as a robot does that flies against the wind.
class Lean {
public:
    /// Call it once per tick in the air.
    void note(const Senses& senses);
    /// The larger one of the differences of roll and pitch to their means.
    double tiltFrom_rad(const Pose& pose) const;
    /// The slope of a plane on which a robot with this yaw would stand at its mean lean, upward along the map's axes.
    Vec2 slope(double yaw_rad) const;
    /// How far beside the robot (map frame) the line lies that its belly scanner scans at this height; zero without
    /// wind.
    Vec2 scanAside_m(double yaw_rad, double altitude_m) const;

private:
    std::optional<Seconds> noted_;
    double roll_rad_ = 0.0;
    double pitch_rad_ = 0.0;
};

/// Returns whether the scan may be written into the map: the robot must be as level as the wind allows, not turn
/// quickly, and be high enough that the rays are not nearly horizontal. Scans in transit are as good as those on a
/// lane; scans on the ground are not used.
bool goodForMap(const Senses& senses, bool airborne, const Lean& lean, const Settings& settings);

/// Publishes only what changed. Owned by one robot.
class FlightLog {
public:
    /// Marks a place (map frame) at the robot's present height.
    void mark(agent::MarkKind kind, const Vec2& place_m, const Senses& senses, agent::CommandPort& port) const;
    /// Publishes the pose, a path mark every meter, and the scan if it is good for the map. Returns true if it is.
    bool tick(const Senses& senses, bool airborne, const Settings& settings, agent::CommandPort& port);
    /// Marks new risks and diversions.
    void risks(const Senses& senses, const EvasionDecision& decision, agent::CommandPort& port) const;
    /// Publishes a goal that differs from the last one; nullopt means that there is no goal.
    void goal(std::optional<Vec3> goal_in_map_m, agent::CommandPort& port);
    /// Makes the path continue from the next position, because the position estimate has jumped.
    void forgetPath() { last_path_m_.reset(); }
    const Lean& lean() const { return lean_; }

private:
    Lean lean_;
    std::optional<Vec3> last_path_m_;
    std::optional<Vec3> last_goal_m_;
};

} // namespace usar::airrobot
