// A robot's path thinned out as it grows: straight lanes cost two points, however long they are.
#pragma once

#include <vector>

#include "core/base/geometry.h"

namespace usar::widgets {

/// Keeps a point when the path bends by more than `tolerance_m` since the last kept one; the newest point is always
/// the last. Drawn every frame, so its length bounds the frame time.
class Trail {
public:
    explicit Trail(double tolerance_m = 0.1) : tolerance_m_(tolerance_m) {}

    /// Points that are not finite or hardly differ from the last one are ignored.
    void add(const Vec2& point_in_map_m);
    void clear();
    const std::vector<Vec2>& points_m() const { return points_m_; }

private:
    /// Whether a straight line to `end_m` still passes all points that it would replace.
    bool pendingFit(const Vec2& end_m) const;

    double tolerance_m_;
    std::vector<Vec2> points_m_;
    std::vector<Vec2> pending_m_; ///< passed since the last kept point
};

} // namespace usar::widgets
