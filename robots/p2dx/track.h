// The recent path of the robot, according to its INS.
#pragma once

#include <deque>

#include "core/base/clock.h"
#include "core/base/geometry.h"

namespace usar::p2dx {

/// The motion that the robot was commanded to make in a step.
enum class Motion { Standing, Straight, Curve, Back, Turning };

/// Works in the map frame. The INS's position and height drift a little with the distance, and its attitude drifts a
/// lot. Therefore slopes are computed from positions, and the yaw is pulled toward the course while the robot drives
/// straight.
class Track {
public:
    /// Stands for a distance that is not known yet; greater than any real one.
    static constexpr double unknown_m = 1e9;

    /// Adds the step since the last update; `motion` is what the robot was commanded to do meanwhile.
    void update(Seconds now, const Pose& ins_in_map, Motion motion);
    /// Forgets the ground behind the robot, because it is about to turn in place.
    void leaveWay() { way_.clear(); }
    /// Restarts the observation for progress_m, because the robot stands on purpose or has just been freed.
    void forgetPlaces() { places_.clear(); }

    /// The estimated pose: position and corrected yaw; roll and pitch are always 0.
    Pose base_in_map() const { return {position_m_, 0.0, 0.0, yaw_rad_}; }
    /// The horizontal distance driven so far.
    double distance_m() const { return distance_m_; }
    /// Horizontal distance and turn of the last step. The turn is positive to the left.
    double lastStep_m() const { return last_step_m_; }
    double lastTurn_rad() const { return last_turn_rad_; }
    /// The length of the straight path that leads here, which is ground known to be free behind the robot.
    double wayBehind_m() const;
    /// The slope of the last stretch of the path, positive downhill; 0 if the stretch is too short.
    double descent_rad() const;
    /// The greatest distance from here at which the robot was during this time; `unknown_m` if it has been observed for
    /// a shorter time.
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
    /// Moves the correction by a small share of the difference between course and yaw. Ignores short steps and slips.
    void correctYaw(const Vec3& step_m);

    bool begun_ = false;
    Vec3 position_m_ = Vec3::Zero();
    double ins_yaw_rad_ = 0.0;
    double correction_rad_ = 0.0; ///< to be added to the INS's yaw
    double yaw_rad_ = 0.0;
    double distance_m_ = 0.0;
    double last_step_m_ = 0.0;
    double last_turn_rad_ = 0.0;
    std::deque<Step> way_;     ///< forward steps since the robot last turned in place
    std::deque<Place> places_; ///< positions of the last ten minutes
};

} // namespace usar::p2dx
