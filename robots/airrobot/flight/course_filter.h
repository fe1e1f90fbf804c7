// Estimates the drift of the heading from the course: in steady flight the robot moves in the commanded direction.
#pragma once

#include <optional>

#include "core/base/clock.h"
#include "core/base/geometry.h"

namespace usar::airrobot {

/// The INS adds noise to each turn, so its heading drifts by about one degree per right angle
/// (robots-and-worlds.md 4.4), which misplaces a scan at 19 m by a third of a meter per degree. Its position does not
/// depend on its heading. Therefore, after the commanded velocity (robot frame) has been steady for a while, the
/// direction of the INS's displacement minus the commanded direction is the true heading, with a noise of 3 degrees per
/// tick. This is a Kalman filter with one state, the correction; turns increase its variance. It does not use ground
/// truth. Owned by one robot.
class CourseFilter {
public:
    /// Takes an INS reading and the velocity that is commanded now. Call it for every reading; it skips readings that
    /// come faster than usual ticks, because its noise model is for steps of a usual tick.
    void update(Seconds now, const Pose& ins_in_map, const Vec2& commanded_in_base_m_s);
    /// The correction to add to the INS's yaw.
    double correction_rad() const { return correction_rad_; }
    /// Starts again without a correction.
    void reset();

private:
    /// Updates the correction by one step; `expected_rad` is the course according to the INS's yaw and the command.
    void learn(const Vec2& step_m, double expected_rad);

    std::optional<Seconds> last_at_;
    std::optional<Pose> last_;
    Vec2 command_m_s_ = Vec2::Zero(); ///< command with which the steady ticks began
    int steady_ticks_ = 0;
    double correction_rad_ = 0.0;
    double variance_rad2_ = 0.0;
};

} // namespace usar::airrobot
