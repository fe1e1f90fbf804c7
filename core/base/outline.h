// Outlines of solids as seen from above.
#pragma once

#include <vector>

#include "core/base/geometry.h"

namespace usar {

/// A convex polygon, counter-clockwise, in meters.
using Outline = std::vector<Vec2>;

/// The convex hull of any points, in any order; of fewer than three it has no area.
Outline hullOf(std::vector<Vec2> points_m);
/// The outline of a box; `size_m` is its full extent along its own axes.
Outline outlineOfBox(const Pose& center, const Vec3& size_m);
/// The outline of a cylinder along its own z axis, with 24 corners to a circle; `size_m` are its diameters and height.
Outline outlineOfCylinder(const Pose& center, const Vec3& size_m);
/// The outline of a sphere, however it is turned.
Outline outlineOfSphere(const Vec2& center_m, double radius_m);

} // namespace usar
