// The estimated poses of the robot during the last seconds.
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

} // namespace usar::airrobot
