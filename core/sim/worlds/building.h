// What generated worlds are built from: numbers that files keep exactly, grounds, trees, blocks.
#pragma once

#include <cstddef>
#include <functional>

#include "core/base/random.h"
#include "core/sim/world.h"

namespace usar::sim {

double wholeMillimetres(double value_m);
/// Evenly drawn, in whole millimetres.
double between(Random& random, double low_m, double high_m);

/// The square or rectangle of posts that a ground is made of, centered on the map's origin.
struct PostGrid {
    std::size_t columns = 0;
    std::size_t rows = 0;
    double step_m = 1.0;
    double steps_per_m = 1024.0; ///< heights are rounded to this; see world_writer.h for which relief allows which
};

/// Heights of a function of the place, in whole steps.
Terrain terrainOf(const PostGrid& grid, const std::function<double(const Vec2&)>& height_m);

/// The lowest ground on a circle and its center, in whole millimetres below it.
double lowestGround_m(const Terrain& terrain, const Vec2& at_m, double radius_m);

/// Of random size, rooted so deep that slopes leave no gap under the trunk's lower side. Crowns reach the 6 m above
/// ground at which an AirRobot scans.
Plant makeTree(Random& random, const Terrain& terrain, const Vec2& at_m);

/// The upright box between two corners.
Box block(const Vec3& low_m, const Vec3& high_m);

} // namespace usar::sim
