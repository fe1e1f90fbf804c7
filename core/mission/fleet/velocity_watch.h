// Velocity of a robot in its own frame, computed from the poses that it reports; feedback for driving by hand.
#pragma once

#include <deque>
#include <optional>

#include "core/mission/session/session_update.h"

namespace usar::mission {

/// Velocity and yaw rate of a robot.
struct BodyTwist {
    Vec3 velocity_m_s = Vec3::Zero(); ///< forward, left, up
    double yaw_rate_rad_s = 0.0;      ///< counterclockwise is positive
    bool planar = false;              ///< from odometry, which does not know the vertical
    bool operator==(const BodyTwist&) const = default;
};

/// For one robot. Averaged over the last half second of its clock, because poses come with two decimals; from ground
/// truth if the robot has it, else INS, else odometry. Values only, no thread of its own.
class VelocityWatch {
public:
    static constexpr Seconds window{0.5};

    void take(const SessionUpdate& update);
    /// Nullopt until there are two poses, and when poses stop coming.
    std::optional<BodyTwist> twist() const;

private:
    enum class Source { None, Odometry, Ins, GroundTruth };
    struct Sample {
        Seconds time{0.0};
        Pose base_in_map{};
    };
    void move(Source source, const Pose& base_in_map);

    Source best_ = Source::None;
    Seconds now_{0.0};
    std::deque<Sample> samples_;
};

} // namespace usar::mission
