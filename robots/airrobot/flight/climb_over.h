// Climbs over an obstacle that cannot be flown around: away from it, straight up until the way is free, then across.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "robots/airrobot/flight/evasion.h"
#include "robots/airrobot/flight/obstacle_memory.h"
#include "robots/airrobot/flight/ring_touch.h"
#include "robots/airrobot/flight/senses.h"
#include "robots/airrobot/flight/threat_zones.h"
#include "robots/airrobot/settings.h"

namespace usar::airrobot {

/// The state of a climb. Sinking: away from something that its ring has met. Over: the robot is high enough to cross.
/// Failed: it has reached the maximum height, or met something wherever it tried.
enum class ClimbState { Inactive, Backing, Climbing, Sinking, Over, Failed };

/// The instructions for one tick.
struct ClimbStep {
    ClimbState state = ClimbState::Inactive;
    Vec2 place_m = Vec2::Zero(); ///< place to go to (Backing) or to stay at (Climbing, Sinking), map frame
    /// Commanded rate of climb; 0 while backing, negative while sinking.
    double climb_m_s = 0.0;
};

/// Treetops are wider above than where the sonars see them. Therefore the robot first moves to a place that is at least
/// `climb_standoff_m` away from everything known, if there is one. Owned by one robot; call `step` once per tick while
/// active.
class ClimbOver {
public:
    /// Begins by backing to the best place nearby (see climbPlace_m). `obstacles` are those at the robot's height.
    void start(const Senses& senses, std::span<const Obstacle> obstacles, const Settings& settings,
               const Retreat& retreat = {});
    /// `goal_m` is the point to steer at after the climb; the way to it must be free. The climb ends at the height
    /// `highest_m` (map z), for example below a ceiling, and fails unless the way is free there.
    ClimbStep step(const Senses& senses, const ThreatPicture& picture, std::span<const Obstacle> obstacles,
                   const Vec2& goal_m, double highest_m, const Settings& settings);
    /// Notes whether the ring has met something; the climb goes on at another place then. Call it before each `step`,
    /// with the rate of climb that was commanded last; for `slope` see RingTouch.
    void feel(const Senses& senses, const Vec2& slope, double commanded_m_s, const Settings& settings);
    /// Whether the robot is on its way to the place or climbing there; false once it is over or has failed.
    bool active() const {
        return state_ == ClimbState::Backing || state_ == ClimbState::Climbing || state_ == ClimbState::Sinking;
    }
    bool sinks() const { return state_ == ClimbState::Sinking; } ///< away from what its ring has met
    /// True if what its ring has met may still press it down at the height `z_m` (map).
    bool mayBePressed(double z_m) const;
    /// Makes the climb inactive, whatever its state.
    void reset() { *this = {}; }

private:
    /// True if the robot faces the goal and neither sonars nor memory show anything on the first meters.
    bool wayIsFree(const Senses& senses, const ThreatPicture& picture, std::span<const Obstacle> obstacles,
                   const Vec2& goal_m) const;

    void sink(const Senses& senses, std::span<const Obstacle> obstacles, const Settings& settings);

    ClimbState state_ = ClimbState::Inactive;
    Vec2 place_m_ = Vec2::Zero();
    RingTouch touch_;
    double commanded_m_s_ = 0.0;
    std::vector<Obstacle> met_;            ///< by its ring, in this climb
    std::vector<Vec3> failed_m_;           ///< from where it has sunk for that
    double begins_m_ = 0.0;                ///< map z at which it began to climb
    double sinks_to_m_ = 0.0;              ///< map z
    Seconds since_{0.0};                   ///< start of the maneuver
    std::optional<double> free_since_z_m_; ///< height from which on the way has been free; nullopt while it is blocked
};

/// Returns the best place for a climb: within 6 m, reachable at this height, and as far from everything known as
/// possible, up to `standoff_m`. Short ways are preferred, and places where the robot has flown: crowns behind it may
/// be unknown. From places where it has `failed` it keeps away, too.
Vec2 climbPlace_m(std::span<const Obstacle> obstacles, const Vec2& here_m, double standoff_m,
                  const Retreat& retreat = {}, std::span<const Vec3> failed_m = {});

/// Returns the distance to the nearest of these things, at most `enough_m`. It is less near the places where a climb
/// has `failed`, because what ended that climb may be above the robot, where nothing hears it.
double roomForClimb_m(std::span<const Obstacle> things, const Vec2& at_m, double enough_m,
                      std::span<const Vec3> failed_m);

} // namespace usar::airrobot
