#include "core/mission/fleet/velocity_watch.h"

#include "core/protocol/fields.h"

namespace usar::mission {

namespace {

constexpr Seconds patience{1.5}; // For a robot that has stopped reporting its pose.

} // namespace

void VelocityWatch::take(const SessionUpdate& update) {
    if (update.rewound)
        *this = {};
    for (const protocol::InfoLine& line : update.lines) {
        now_ = protocol::timeOf(line.message).value_or(now_);
        if (const auto* const truth = std::get_if<protocol::GroundTruthReading>(&line.message))
            move(Source::GroundTruth, truth->base_in_map);
        else if (const auto* const ins = std::get_if<protocol::InsReading>(&line.message))
            move(Source::Ins, ins->base_in_map);
        else if (const auto* const odometry = std::get_if<protocol::OdometryReading>(&line.message);
                 odometry && odometry->base_in_start)
            move(Source::Odometry, *odometry->base_in_start);
    }
}

void VelocityWatch::move(Source source, const Pose& base_in_map) {
    if (source < best_)
        return;
    if (source > best_ || (!samples_.empty() && now_ < samples_.back().time))
        samples_.clear();
    best_ = source;
    if (!samples_.empty() && samples_.back().time == now_)
        samples_.back().base_in_map = base_in_map;
    else
        samples_.push_back({now_, base_in_map});
    while (samples_.size() > 2 && samples_[1].time <= now_ - window)
        samples_.pop_front();
}

std::optional<BodyTwist> VelocityWatch::twist() const {
    if (samples_.size() < 2 || now_ - samples_.back().time > patience)
        return std::nullopt;
    const Sample& from = samples_.front();
    const Sample& to = samples_.back();
    const double span_s = (to.time - from.time).count();
    const double turned_rad = normalizedAngle(to.base_in_map.yaw_rad - from.base_in_map.yaw_rad);
    const Vec3 way_in_map_m = to.base_in_map.position_m - from.base_in_map.position_m;
    const Pose heading{.yaw_rad = from.base_in_map.yaw_rad + turned_rad / 2.0}; // Level, so that up stays up.
    return BodyTwist{(inverse(heading) * way_in_map_m) / span_s, turned_rad / span_s, best_ == Source::Odometry};
}

} // namespace usar::mission
