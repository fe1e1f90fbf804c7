// A height field: the ground of a world.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/base/geometry.h"

namespace usar::sim {

/// Square posts, row-major; row 0 has the lowest y. Between posts the surface is two triangles per cell, split along
/// the (0,0)-(1,1) diagonal, the same one that the physics engine is told to use. Map frame, z up, meters. Immutable;
/// without posts when default-constructed.
class Terrain {
public:
    Terrain() = default;
    /// `heights_m.size()` must be columns * rows, with at least 2 posts each way and `step_m` above 0; `origin_m` is
    /// the post with the lowest x and y.
    Terrain(std::size_t columns, std::size_t rows, double step_m, Vec2 origin_m, std::vector<float> heights_m);
    /// A level floor of as few posts as square cells allow; nullopt if the extent is empty, or its sides have no common
    /// measure of at least 1/4096 of the longer one.
    static std::optional<Terrain> level(const Rectangle& extent, double z_m);

    std::size_t columns() const { return columns_; }
    std::size_t rows() const { return rows_; }
    double step_m() const { return step_m_; }
    const Vec2& origin_m() const { return origin_m_; }
    /// Bounds of the posts; an empty rectangle if there are none.
    Rectangle extent() const;
    const std::vector<float>& heights_m() const { return heights_m_; }
    /// Height of a post; the indices are not checked.
    float post_m(std::size_t column, std::size_t row) const { return heights_m_[row * columns_ + column]; }
    /// Lowest and highest post; 0 if there are none.
    float minimum_m() const { return minimum_m_; }
    float maximum_m() const { return maximum_m_; }
    bool empty() const { return heights_m_.empty(); }

    /// Height of the triangle at the point, which is clamped to the extent; 0 if there are no posts.
    double height_m(const Vec2& point_m) const;

    bool operator==(const Terrain&) const = default;

private:
    std::size_t columns_ = 0;
    std::size_t rows_ = 0;
    double step_m_ = 1.0;
    Vec2 origin_m_ = Vec2::Zero();
    std::vector<float> heights_m_;
    float minimum_m_ = 0.0f;
    float maximum_m_ = 0.0f;
};

} // namespace usar::sim
