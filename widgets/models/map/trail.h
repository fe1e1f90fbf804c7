// A robot's path, thinned out as it grows: a straight lane costs two points, however long it is.
#pragma once

#include <vector>

#include "core/base/geometry.h"

namespace usar::widgets {

/// Keeps a point only if the path bends by more than `tolerance_m` since the last kept one, or by four times as much in
/// height, which the map does not show; the newest point is always the last. The trail is drawn in every frame, so its
/// length bounds the frame time. It is interrupted where poses were left out.
class Trail {
public:
    explicit Trail(double tolerance_m = 0.1) : tolerance_m_(tolerance_m) {}

    /// A longer step between two poses is a gap: no robot goes as far between two of its messages.
    static constexpr double longest_step_m = 10.0;

    /// Ignores points that are not finite or closer to the last one than half the tolerance.
    void add(const Vec3& point_in_map_m);
    void clear();
    /// The kept points in meters of the map frame, oldest first; a point of NaN stands for a gap.
    const std::vector<Vec2>& points_m() const { return points_m_; }
    /// The heights of the same points; NaN for a gap.
    const std::vector<double>& heights_m() const { return heights_m_; }

private:
    /// True if a straight line to `end_m` still passes within the tolerance of all points that it would replace.
    bool pendingFit(const Vec3& end_m) const;
    Vec3 pointAt(std::size_t index) const;
    void keep(const Vec3& point_m);

    double tolerance_m_;
    std::vector<Vec2> points_m_;
    std::vector<double> heights_m_;
    std::vector<Vec3> pending_m_; ///< points since the last kept one
};

} // namespace usar::widgets
