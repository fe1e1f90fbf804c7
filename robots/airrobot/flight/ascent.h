// The climb after a take-off, with looks at what is above.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "robots/airrobot/flight/obstacle_memory.h"
#include "robots/airrobot/flight/overhead.h"
#include "robots/airrobot/settings.h"

namespace usar::airrobot {

/// The visible part of a trunk (for the scanner's level rays and the sonars) ends at most this far below the robot.
inline constexpr double trunk_margin_m = 0.3;

struct AscentStep {
    double climb_m_s = 0.0;
    double right_m_s = 0.0;     ///< not 0: the robot rolls to look up
    bool returns = false;       ///< to its place after that, at once
    bool turns = false;         ///< to look around
    bool looked_around = false; ///< true in one tick: now it knows what stands near it
    bool reached = false;
};

/// The belly scanner looks sideways as far as the horizon, so it looks up on one side while the robot rolls. The robot
/// rolls as it sets off to the right and comes back, once it is clear of the ground, and again where it has not seen
/// farther up: no sonar looks to the sides, but a robot that turns left to look around has listened on its right. It
/// climbs fast as far as it has come down before, and beyond that slowly enough to bear a touch: it does not see crowns
/// ahead or behind. Where it has not come down, it first turns around near the ground, so that the scanner sees all
/// trunks nearby: the crowns of trees are above them. Owned by one robot; make a new one for each take-off.
class Ascent {
public:
    /// The robot came straight down to this place from `known_m` above it.
    explicit Ascent(double known_m = 0.0) : known_m_(known_m) {}
    /// In the air, after a flight through a door: it has seen what is around, and nothing of what is above.
    static Ascent beyondDoor() {
        Ascent ascent;
        ascent.knows_around_ = true;
        ascent.free_m_ = 0.0;
        return ascent;
    }

    /// Call it once per tick. The caller holds the robot over the goal. The height counts as reached below a ceiling,
    /// too.
    AscentStep step(const Senses& senses, const Vec3& goal_m, const Overhead& overhead, const ObstacleMemory& memory,
                    const Settings& settings);

    /// What the sonars heard as it looked around, well above the ground: a thin trunk may stand between two scans.
    const std::vector<Obstacle>& heard() const { return heard_; }
    /// Adds what they hear now. Call it on the way to another place for the climb.
    void listen(const Senses& senses);

private:
    bool lookAround(const Senses& senses, AscentStep& step);

    static constexpr double first_look_m = 2.0; ///< above the place of the take-off, where people stand

    double known_m_;
    bool knows_around_ = false;
    double free_m_ = first_look_m; ///< above its beginning, nothing is in the way
    std::optional<double> from_z_m_;
    std::optional<Seconds> looking_since_;
    double next_look_m_ = 0.0; ///< height of the next look
    double turned_rad_ = 0.0;
    std::optional<double> last_yaw_rad_;
    std::vector<Obstacle> heard_;
};

/// True if the sonar hears something that is surely not the ground.
bool isNoGround(const SonarEcho& echo, const Senses& senses);

/// True if a sonar hears something ahead, nearer than this, that is surely not the ground.
bool hearsAhead(const Senses& senses, double within_m);

/// The rate of climb where nobody has been yet.
double carefulClimb_m_s(const Settings& settings);

} // namespace usar::airrobot
