// Tells the heading's drift from the course: in steady flight the robot moves where it was told to.
#pragma once

#include <optional>

#include "core/base/clock.h"
#include "core/base/geometry.h"

namespace usar::airrobot {

/// The INS adds noise to each turn, so its heading drifts by about a degree per right angle (robots-and-worlds 4.4),
/// and a scan at 19 m is misplaced by a third of a metre per degree. Its position does not depend on its heading. So
/// where the commanded velocity (robot frame) has been steady, the direction of the INS's displacement less the
/// commanded direction is the true heading, with 3 degrees of noise a tick. A Kalman filter of one state, the
/// correction; turning makes it less sure. No ground truth is involved. Owned by one robot; told of every INS reading,
/// of which it takes no more than one in a usual tick: its noise is that of such a step.
class CourseFilter {
public:
    void update(Seconds now, const Pose& ins_in_map, const Vec2& commanded_in_base_m_s);
    /// To be added to the INS's yaw.
    double correction_rad() const { return correction_rad_; }
    void reset();

private:
    void learn(const Vec2& step_m, double expected_rad);

    std::optional<Seconds> last_at_;
    std::optional<Pose> last_;
    Vec2 command_m_s_ = Vec2::Zero();
    int steady_ticks_ = 0;
    double correction_rad_ = 0.0;
    double variance_rad2_ = 0.0;
};

} // namespace usar::airrobot
