// The robot's estimate of its pose from the INS: the poses of the last seconds, and a correction of the heading.
#pragma once

#include <deque>
#include <optional>

#include "core/base/clock.h"
#include "core/base/geometry.h"

namespace usar::airrobot {

/// Poses in the map frame by protocol time. On some servers a scan is one tick older than the other readings with it
/// (protocol.md 1.8), so it must be placed where the robot was then. Keeps the poses of the last `span`.
class PoseHistory {
public:
    explicit PoseHistory(Seconds span = Seconds(2.0)) : span_(span) {}

    /// Adds a pose. If the time is not later than the last one, the pose replaces the last pose.
    void add(Seconds time, const Pose& base_in_map);
    /// Forgets all poses; call it when the estimate has jumped (INS reset).
    void clear() { poses_.clear(); }

    /// Returns the pose at a time. Interpolates position and angles linearly, the angles along the shorter way; outside
    /// the stored times it returns the first or last pose. Returns nullopt if there are no poses.
    std::optional<Pose> at(Seconds time) const;
    /// The mean velocity over the newest 0.45 s (two usual ticks), but at least over the last two poses; zero until two
    /// poses are known. Map frame.
    Vec3 velocity_m_s() const;
    /// The mean yaw rate over the same time.
    double yawRate_rad_s() const;

private:
    struct Entry {
        Seconds time;
        Pose pose;
    };
    /// Returns the pose from which rates are computed; nullptr if there are fewer than two.
    const Entry* earlier() const;

    Seconds span_;
    std::deque<Entry> poses_; ///< oldest first
};

/// Estimates the drift of the heading from the course: in steady, calm flight the robot moves in the commanded
/// direction. The INS adds noise to each turn, so its heading drifts by about one degree per right angle
/// (robots-and-worlds.md 4.4), which misplaces a scan at 19 m by a third of a meter per degree. Its position does not
/// depend on its heading. Wind carries the robot aside, too, but in the same direction of the map whichever way it
/// flies. So this is a Kalman filter with three states: the correction of the heading, whose variance turns increase,
/// and the two components of what wind adds to the velocity. It learns from each tick in which the commanded velocity
/// (robot frame) has been steady for a while and the robot flies straight ahead or hovers. It does not use ground
/// truth. Owned by one robot.
class CourseFilter {
public:
    /// Takes an INS reading and the velocity that is commanded now relative to the air; nullopt for a robot that may be
    /// unable to obey, as on the ground. Call it for every reading; it skips readings that come faster than usual
    /// ticks, because its noise model is for steps of a usual tick.
    void update(Seconds now, const Pose& ins_in_map, const std::optional<Vec2>& commanded_in_base_m_s);
    /// The correction to add to the INS's yaw.
    double correction_rad() const { return state_[0]; }
    /// The velocity (map frame) that the wind adds to the robot's own, as far as the filter knows it.
    Vec2 wind_m_s() const { return state_.tail<2>(); }
    /// The INS was set: there is no correction. The wind may be another one, but most likely is the same.
    void insWasSet();

private:
    /// Uses the velocity (map frame) of one step; `heading_rad` is the INS's yaw in its middle.
    void learn(const Vec3& velocity_m_s, double heading_rad, const Vec2& commanded_in_base_m_s);
    /// Lets the state's variance grow as it may have changed in a step.
    void predict(Seconds step, double turn_rad);
    /// Forgets how well the wind was known, because it is another one now.
    void doubtWind();

    std::optional<Seconds> last_at_;
    std::optional<Pose> last_;
    Vec2 command_m_s_ = Vec2::Zero(); ///< command with which the steady ticks began
    int steady_ticks_ = 0;
    int surprises_ = 0;         ///< steps in a row that the state cannot explain
    Vec3 state_ = Vec3::Zero(); ///< correction (rad), wind (m/s)
    Eigen::Matrix3d covariance_ = Vec3(0.0, 1.0, 1.0).asDiagonal();
};

} // namespace usar::airrobot
