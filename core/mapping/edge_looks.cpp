#include "core/mapping/edge_looks.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include <Eigen/Cholesky>

namespace usar::mapping {

namespace {

constexpr std::int32_t tile_cells = HeightTile::side;
constexpr std::int32_t cells_aside = 2; ///< Points in cells so near to each side count.
constexpr double bell_m = 0.25;         ///< Standard deviation of the weights by distance.
constexpr double least_weight = 0.3;
constexpr double ridge = 0.01; ///< keeps the slope of the regression small where points are in a line
constexpr double flattest = 0.2;
constexpr double least_hit_weight = 0.05;
/// A beam that ends sooner after it went through the height of an outline, and no lower than the thing, has hit the
/// thing: the outline of a flat roof is told a little too high.
constexpr double beyond_m = 1.0;
/// Beams are looked at as far to each side of the one that leads to the center of a cell.
constexpr std::ptrdiff_t beams_aside = 4;
constexpr double farthest_m = 17.0; ///< Farther to the side, beams are too flat.
constexpr double deepest_m = 14.0;  ///< So much below the scanner, outlines are looked for.
constexpr double most_lean = 0.3;

std::int32_t tileOf(std::int32_t cell) {
    return (cell >= 0 ? cell : cell - tile_cells + 1) / tile_cells;
}

/// 1, x and y.
Eigen::Vector3f pointAt(const Vec2& from_center_m) {
    return Eigen::Vector3d(1.0, from_center_m.x(), from_center_m.y()).cast<float>();
}

std::size_t offsetOf(GridIndex cell, GridIndex tile) {
    return static_cast<std::size_t>((cell.row - tile.row * tile_cells) * tile_cells + cell.column -
                                    tile.column * tile_cells);
}

/// The cells near the plane of a scan: those near the line in which it meets level ground, which is not below the
/// scanner where the plane leans.
class ScanLine {
public:
    ScanLine(const Vec3& scanner_m, const Vec3& normal, double cell_size_m) : from_(scanner_m.head<2>() / cell_size_m) {
        const Vec2 across = normal.head<2>().normalized();
        axis_ = std::abs(across.y()) > std::abs(across.x()) ? 0 : 1;
        slope_ = -across[axis_] / across[1 - axis_];
        reach_ = farthest_m / cell_size_m * std::abs(across[1 - axis_]);
        const double lean = std::clamp(normal.z() / normal.head<2>().norm(), -most_lean, most_lean);
        shift_ = deepest_m * lean / cell_size_m / across[1 - axis_];
    }

    template <class Take>
    void eachCell(Take&& take) const {
        const auto first = static_cast<std::int32_t>(std::floor(from_[axis_] - reach_));
        const auto last = static_cast<std::int32_t>(std::floor(from_[axis_] + reach_));
        for (std::int32_t along = first; along <= last; ++along) {
            const double middle = from_[1 - axis_] + slope_ * (along + 0.5 - from_[axis_]);
            const auto low = static_cast<std::int32_t>(std::floor(middle + std::min(0.0, shift_) - 1.0));
            const auto high = static_cast<std::int32_t>(std::floor(middle + std::max(0.0, shift_) + 1.0));
            for (std::int32_t across = low; across <= high; ++across)
                take(axis_ == 0 ? GridIndex{along, across} : GridIndex{across, along});
        }
    }

private:
    Vec2 from_; ///< this and the rest in cells
    int axis_ = 0;
    double slope_ = 0.0; ///< The line moves aside by this for each cell along the axis.
    double reach_ = 0.0;
    double shift_ = 0.0; ///< The line is shifted by this at the greatest depth.
};

} // namespace

void EdgeLooks::addEdge(GridIndex cell, const Edge& edge) {
    const GridIndex tile{tileOf(cell.column), tileOf(cell.row)};
    std::unique_ptr<Numbers>& numbers = tiles_[tile];
    if (!numbers)
        numbers = std::make_unique<Numbers>(Numbers{});
    cells_.push_back({edge, {}});
    (*numbers)[offsetOf(cell, tile)] = static_cast<std::uint32_t>(cells_.size());
    last_ = {};
}

const EdgeLooks::Cell* EdgeLooks::cellAt(GridIndex cell) const {
    const GridIndex tile{tileOf(cell.column), tileOf(cell.row)};
    if (!last_.second || last_.first != tile) {
        const auto found = tiles_.find(tile);
        if (found == tiles_.end())
            return nullptr;
        last_ = {tile, found->second.get()};
    }
    const std::uint32_t number = (*last_.second)[offsetOf(cell, tile)];
    return number == 0 ? nullptr : &cells_[number - 1];
}

EdgeLooks::Cell* EdgeLooks::cellAt(GridIndex cell) {
    return const_cast<Cell*>(std::as_const(*this).cellAt(cell));
}

void EdgeLooks::look(const Beams& beams, const Pose& scanner) {
    turn_ = scanner.rotation().toRotationMatrix();
    const Vec3 normal = turn_.col(2);
    const double most = cell_size_m_ * double(1 << 30);
    // A scan that is level sees no edges from above. The comparisons are false for NaN.
    if (cells_.empty() || !(normal.head<2>().norm() > 0.5) || !(scanner.position_m.cwiseAbs().maxCoeff() < most / 2.0))
        return;
    finder_.find(beams, scanner, hits_m_);
    takeHits(scanner.position_m);
    ScanLine(scanner.position_m, normal, cell_size_m_).eachCell([&](GridIndex at) {
        Cell* const cell = cellAt(at);
        if (!cell)
            return;
        const Vec2 center_m = cell_size_m_ * Vec2(at.column + 0.5, at.row + 0.5);
        const Vec3 way_m = Vec3(center_m.x(), center_m.y(), double(cell->edge.level_m)) - scanner.position_m;
        if (std::abs(way_m.dot(normal)) < 0.75 * cell_size_m_) // about half a diagonal
            takePasses(*cell, center_m, beams, scanner);
    });
}

/// A hit on the thing is inside of its outline.
void EdgeLooks::takeHits(const Vec3& scanner_m) {
    for (const Vec3& hit_m : hits_m_) {
        if (!hit_m.allFinite())
            continue;
        const Vec2 place = (hit_m.head<2>() / cell_size_m_).array().floor().matrix();
        const GridIndex at{static_cast<std::int32_t>(place.x()), static_cast<std::int32_t>(place.y())};
        Cell* const cell = cellAt(at);
        if (!cell || !(hit_m.z() > double(cell->edge.least_m)))
            continue;
        const auto weight = static_cast<float>(std::max(least_hit_weight, -(hit_m - scanner_m).normalized().z()));
        const Eigen::Vector3f point = pointAt(hit_m.head<2>() - cell_size_m_ * (place + Vec2::Constant(0.5)));
        cell->normal += weight * point * point.transpose();
        cell->covered += weight * point;
    }
}

/// Where a beam has gone down through the height of the outline, it was outside of it.
void EdgeLooks::takePasses(Cell& cell, const Vec2& center_m, const Beams& beams, const Pose& scanner) {
    const Vec3 way_m = Vec3(center_m.x(), center_m.y(), double(cell.edge.level_m)) - scanner.position_m;
    const double angle_rad = std::atan2(way_m.dot(turn_.col(1)), way_m.dot(turn_.col(0)));
    const std::vector<Vec2>& rays = directions_.of(beams.resolution_rad, beams.fov_rad, beams.ranges_m.size());
    const auto middle =
        static_cast<std::ptrdiff_t>(std::lround((angle_rad + beams.fov_rad / 2.0) / beams.resolution_rad));
    const auto last = std::min(static_cast<std::ptrdiff_t>(rays.size()) - 1, middle + beams_aside);
    for (auto k = std::max(std::ptrdiff_t(0), middle - beams_aside); k <= last; ++k) {
        const Vec3 ray = turn_.leftCols<2>() * rays[static_cast<std::size_t>(k)];
        if (ray.z() > -flattest)
            continue;
        const double to_m = way_m.z() / ray.z();
        const double range_m = beams.ranges_m[static_cast<std::size_t>(k)];
        const bool below = scanner.position_m.z() + range_m * ray.z() < double(cell.edge.least_m);
        if (!(to_m > 0.0 && (range_m > to_m + beyond_m || (below && range_m > to_m))))
            continue;
        const Vec2 off_m = scanner.position_m.head<2>() + to_m * ray.head<2>() - center_m;
        if (off_m.cwiseAbs().maxCoeff() <= cell_size_m_ / 2.0)
            cell.normal += static_cast<float>(-ray.z()) * pointAt(off_m) * pointAt(off_m).transpose();
    }
}

std::optional<double> EdgeLooks::coveredShare(GridIndex at) const {
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero(); // Sums of the products of 1, x and y; the lower half.
    Eigen::Vector3d sides = Eigen::Vector3d::Zero();
    if (!cellAt(at))
        return std::nullopt;
    for (std::int32_t row = -cells_aside; row <= cells_aside; ++row)
        for (std::int32_t column = -cells_aside; column <= cells_aside; ++column) {
            const Cell* const cell = cellAt({at.column + column, at.row + row});
            if (!cell || !(cell->normal(0, 0) > 0.0f))
                continue;
            // The sums are about the cell's center, and the points are all moved by `off_m` from this one's.
            const Vec2 off_m = cell_size_m_ * Vec2(column, row);
            const Eigen::Matrix3d near = cell->normal.cast<double>();
            const Vec2 first = near.block<2, 1>(1, 0) + near(0, 0) * off_m;
            const Vec2 mean_m = first / near(0, 0); // All points of a cell have one weight.
            const double weight = std::exp(-mean_m.squaredNorm() / (2.0 * bell_m * bell_m));
            const Eigen::Vector3d covered = cell->covered.cast<double>();
            normal(0, 0) += weight * near(0, 0);
            normal.block<2, 1>(1, 0) += weight * first;
            normal.block<2, 2>(1, 1) += weight * (near.block<2, 2>(1, 1) + near.block<2, 1>(1, 0) * off_m.transpose() +
                                                  off_m * first.transpose());
            sides[0] += weight * covered[0];
            sides.tail<2>() += weight * (covered.tail<2>() + covered[0] * off_m);
        }
    if (normal(0, 0) < least_weight)
        return std::nullopt;
    normal.diagonal().tail<2>().array() += ridge * (normal(0, 0) + 0.5);
    return normal.ldlt().solve(sides)[0];
}

} // namespace usar::mapping
