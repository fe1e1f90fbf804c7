// Rays from one place, as a sonar sends them, and what they can meet at all: what none of them can is told at once.
#pragma once

#include <span>

#include "core/base/geometry.h"

namespace usar::sim {

/// Map frame, metres. The directions are unit vectors, at least one, and must outlive it. Its answers err on the side
/// of yes: what it denies no ray meets.
class RayBundle {
public:
    RayBundle(const Vec3& origin_m, std::span<const Vec3> directions);

    const Vec3& origin_m() const { return origin_m_; }
    std::span<const Vec3> directions() const { return directions_; }
    /// Around all rays of one length.
    Eigen::AlignedBox3d box(double length_m) const;
    /// Whether a ray of a length may meet an upright column of any height.
    bool mayMeetColumn(const Vec2& center_m, double radius_m, double length_m) const;

private:
    Vec3 origin_m_;
    std::span<const Vec3> directions_;
    Vec3 lowest_ = Vec3::Zero(); ///< least coordinates of a ray of 1 m, its start included
    Vec3 highest_ = Vec3::Zero();
    bool narrow_ = true; ///< seen from above all rays go the same half way; only then the next three are of use
    Vec2 ahead_;
    Vec2 leftmost_;
    Vec2 rightmost_;
};

} // namespace usar::sim
