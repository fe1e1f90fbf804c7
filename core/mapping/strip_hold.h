// Whether the ground tells where strips lie.
#pragma once

#include <vector>

#include <Eigen/Core>

namespace usar::mapping {

/// The overlaps must explain this share of the variance of the path along a horizontal direction.
constexpr double least_hold = 0.3;
/// Fewer overlaps (on the finest grid) tell nothing.
constexpr std::size_t fewest_overlaps = 200;

/// The shares of the variance of a path that overlaps explain, 0 to 1: along the horizontal direction in which it is
/// most, and across. The covariances are those of x, y, z and yaw by knot (StripSolver), with and without overlaps;
/// zero if one could not be computed.
Eigen::Vector2d holdOf(const std::vector<Eigen::Matrix4d>& with, const std::vector<Eigen::Matrix4d>& without);

} // namespace usar::mapping
