#include "robots/airrobot/flight/pose_history.h"

#include <algorithm>

namespace usar::airrobot {

namespace {

double between(double from_rad, double to_rad, double part) {
    return normalizedAngle(from_rad + part * normalizedAngle(to_rad - from_rad));
}

} // namespace

void PoseHistory::add(Seconds time, const Pose& base_in_map) {
    if (!poses_.empty() && time <= poses_.back().time) {
        poses_.back().pose = base_in_map;
        return;
    }
    poses_.push_back({time, base_in_map});
    while (poses_.size() > 2 && poses_.front().time < time - span_)
        poses_.pop_front();
}

std::optional<Pose> PoseHistory::at(Seconds time) const {
    if (poses_.empty())
        return std::nullopt;
    const auto after = std::ranges::lower_bound(poses_, time, {}, &Entry::time);
    if (after == poses_.end())
        return poses_.back().pose;
    if (after == poses_.begin())
        return after->pose;
    const auto before = std::prev(after);
    const double part = (time - before->time) / (after->time - before->time);
    const Pose& a = before->pose;
    const Pose& b = after->pose;
    return Pose{a.position_m + part * (b.position_m - a.position_m), between(a.roll_rad, b.roll_rad, part),
                between(a.pitch_rad, b.pitch_rad, part), between(a.yaw_rad, b.yaw_rad, part)};
}

const PoseHistory::Entry* PoseHistory::earlier() const {
    if (poses_.size() < 2)
        return nullptr;
    const Seconds wanted = poses_.back().time - Seconds(0.45);
    const auto found = std::ranges::lower_bound(poses_, wanted, {}, &Entry::time);
    return &*std::min(found, std::prev(poses_.end(), 2));
}

Vec3 PoseHistory::velocity_m_s() const {
    const Entry* from = earlier();
    if (!from)
        return Vec3::Zero();
    return (poses_.back().pose.position_m - from->pose.position_m) / (poses_.back().time - from->time).count();
}

double PoseHistory::yawRate_rad_s() const {
    const Entry* from = earlier();
    if (!from)
        return 0.0;
    return normalizedAngle(poses_.back().pose.yaw_rad - from->pose.yaw_rad) / (poses_.back().time - from->time).count();
}

} // namespace usar::airrobot
