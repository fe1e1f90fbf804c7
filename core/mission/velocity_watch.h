// How a robot moves by its own frame, from the poses that it tells: what a hand sees of what it asks.
#pragma once

#include <deque>
#include <optional>

#include "core/mission/session_update.h"

namespace usar::mission {

struct BodyTwist {
    Vec3 velocity_m_s = Vec3::Zero(); ///< forward, left, up
    double yaw_rate_rad_s = 0.0;
    bool planar = false; ///< odometry knows nothing of up and down
    bool operator==(const BodyTwist&) const = default;
};

/// One robot's. Over the last half second of its clock, because poses come with two decimals; from ground truth where
/// the robot has it, else INS, else odometry. Values only, no thread of its own.
class VelocityWatch {
public:
    static constexpr Seconds window{0.5};

    void take(const SessionUpdate& update);
    /// Nothing until there are two poses, and where they stopped coming.
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
