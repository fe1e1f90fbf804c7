// Where the robot came from, by what its INS tells of each step.
#pragma once

#include <deque>

#include "core/base/clock.h"
#include "core/base/geometry.h"

namespace usar::p2dx {

/// How the robot was told to move in a step.
enum class Motion { Standing, Straight, Curve, Back, Turning };

/// Map frame. Position and height drift a little on the way; attitudes drift much, so slopes are taken from the steps,
/// and the yaw is drawn toward the course while the robot drives straight on.
class Track {
public:
    static constexpr double unknown_m = 1e9;

    void update(Seconds now, const Pose& ins_in_map, Motion motion);
    /// What was crossed before lies in another direction now.
    void leaveWay() { way_.clear(); }
    /// The robot stands on purpose, or has just been freed: how long it has been in one place counts anew.
    void forgetPlaces() { places_.clear(); }

    Pose base_in_map() const { return {position_m_, 0.0, 0.0, yaw_rad_}; }
    double distance_m() const { return distance_m_; }
    double lastStep_m() const { return last_step_m_; }
    double lastTurn_rad() const { return last_turn_rad_; }
    /// Straight way driven up to here: ground that is known to be free behind the robot.
    double wayBehind_m() const;
    /// Of the last stretch of way, positive downhill; 0 while there is not enough of it.
    double descent_rad() const;
    /// How far from here the robot was at most during this time; `unknown_m` when it has not been on its way for so
    /// long.
    double progress_m(Seconds during) const;

private:
    struct Step {
        Vec3 position_m = Vec3::Zero();
        double yaw_rad = 0.0;
    };
    struct Place {
        Seconds at{0.0};
        Vec2 position_m = Vec2::Zero();
    };
    void correctYaw(const Vec3& step_m);

    bool begun_ = false;
    Vec3 position_m_ = Vec3::Zero();
    double ins_yaw_rad_ = 0.0;
    double correction_rad_ = 0.0;
    double yaw_rad_ = 0.0;
    double distance_m_ = 0.0;
    double last_step_m_ = 0.0;
    double last_turn_rad_ = 0.0;
    std::deque<Step> way_;     ///< forward steps since the robot last turned in place
    std::deque<Place> places_; ///< of the last minutes
};

} // namespace usar::p2dx
