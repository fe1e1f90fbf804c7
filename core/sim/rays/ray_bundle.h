// Rays from one point, as a sonar sends them. Bounds of the whole bundle rule out at once what none of the rays can
// meet.
#pragma once

#include <span>

#include "core/base/geometry.h"

namespace usar::sim {

/// Map frame, meters. The directions are unit vectors, at least one, and must outlive the bundle. The tests err on the
/// safe side: if one says no, no ray meets the thing.
class RayBundle {
public:
    RayBundle(const Vec3& origin_m, std::span<const Vec3> directions);

    const Vec3& origin_m() const { return origin_m_; }
    std::span<const Vec3> directions() const { return directions_; }
    /// Bounding box of all rays, each with this length.
    Eigen::AlignedBox3d box(double length_m) const;
    /// True if a ray of this length may meet an upright column of any height.
    bool mayMeetColumn(const Vec2& center_m, double radius_m, double length_m) const;

private:
    Vec3 origin_m_;
    std::span<const Vec3> directions_;
    Vec3 lowest_ = Vec3::Zero(); ///< smallest coordinates that a ray of 1 m reaches from the origin, its start included
    Vec3 highest_ = Vec3::Zero(); ///< the largest ones
    bool narrow_ = true; ///< seen from above, all rays point into one half-plane; only then are the next three valid
    Vec2 ahead_;
    Vec2 leftmost_;
    Vec2 rightmost_;
};

} // namespace usar::sim
