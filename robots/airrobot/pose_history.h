// Where the robot believed it was during the last seconds.
#pragma once

#include <deque>
#include <optional>

#include "core/base/clock.h"
#include "core/base/geometry.h"

namespace usar::airrobot {

/// Poses in the map frame by protocol time; a scan is one tick older than its neighbours on some servers
/// (usarsim-protocol 1.8), so it is placed where the robot was, not where it is. Keeps `span` seconds.
class PoseHistory {
public:
    explicit PoseHistory(Seconds span = Seconds(2.0)) : span_(span) {}

    /// A time that is not later than the last one's replaces the last pose.
    void add(Seconds time, const Pose& base_in_map);
    /// The estimate has jumped (INS reset): what was before is of no use.
    void clear() { poses_.clear(); }

    /// Between two poses: linear in position and, the short way, in the angles. Beyond the ends: the end.
    std::optional<Pose> at(Seconds time) const;
    /// Mean over the newest 0.4 s; zero until two poses are known.
    Vec3 velocity_m_s() const;
    double yawRate_rad_s() const;

private:
    struct Entry {
        Seconds time;
        Pose pose;
    };
    const Entry* earlier() const;

    Seconds span_;
    std::deque<Entry> poses_;
};

} // namespace usar::airrobot
