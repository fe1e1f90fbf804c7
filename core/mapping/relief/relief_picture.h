// A picture with depth, and the drawing of triangles and lines into it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/mapping/relief/orbit_camera.h"

namespace usar::mapping {

/// Row-major from the upper left. Each pixel knows how near what it shows is, so it can tell the place in the map.
struct ReliefPicture {
    int width_px = 0;
    int height_px = 0;
    std::vector<std::uint32_t> argb;   ///< opaque, 0xffRRGGBB
    std::vector<float> nearness_per_m; ///< one by the distance along the direction of view; 0: only background

    ReliefPicture() = default;
    ReliefPicture(int width, int height)
        : width_px(width)
        , height_px(height)
        , argb(std::size_t(width) * std::size_t(height), 0xff000000u)
        , nearness_per_m(argb.size(), 0.0f) {}
    bool empty() const { return argb.empty(); }
    std::size_t indexOf(int x_px, int y_px) const {
        return std::size_t(y_px) * std::size_t(width_px) + std::size_t(x_px);
    }
    /// The point of the map that the pixel shows; nullopt outside the picture and where there is only background.
    std::optional<Vec3> pick(int x_px, int y_px, const ReliefProjection& projection) const;
};

/// Columns of a picture. Threads may draw different ones of the same picture at the same time.
struct PictureBand {
    int first_px = 0;
    int end_px = 0;
};

/// A corner as the picture's grid knows it: a sixteenth of a pixel, counted from the center of the upper left one. Two
/// triangles with two corners in common leave no gap.
struct DrawnCorner {
    static constexpr int per_px = 16;
    std::int32_t x = 0;
    std::int32_t y = 0;
    float nearness_per_m = 0.0f;
};

/// The part of a straight line that the picture shows.
struct DrawnLine {
    DrawnCorner from;
    DrawnCorner to;
};

/// Draws into one band of a picture; nearer things hide others, whatever the order.
class ReliefPen {
public:
    /// Farther beside the picture than this, corners have no place on its grid.
    static constexpr float guard_px = 8192.0f;
    /// Nothing is drawn that is farther away than this, because single precision knows no place well there.
    static constexpr float farthest_m = 1e6f;

    ReliefPen(ReliefPicture& picture, const ReliefProjection& projection, PictureBand band)
        : picture_(picture)
        , band_(band)
        , focal_px_(static_cast<float>(projection.focal_px()))
        , middle_x_px_(static_cast<float>(projection.width_px()) / 2.0f)
        , middle_y_px_(static_cast<float>(projection.height_px()) / 2.0f) {}

    /// True for a point, in camera coordinates, that is in front of the camera and within the guard band.
    bool hasPlace(const Eigen::Vector3f& point_m) const;
    /// The corner's place on the grid, for a point that has one.
    DrawnCorner placed(float right_m, float up_m, float forward_m) const;
    /// Draws the triangle if its corners go around counterclockwise as they are seen.
    void triangle(const DrawnCorner& a, const DrawnCorner& b, const DrawnCorner& c, std::uint32_t color);
    /// The same for corners in camera coordinates anywhere; what has no place is cut off. `two_sided`: whichever way
    /// the corners go around.
    void clippedTriangle(const std::array<Eigen::Vector3f, 3>& corners_m, std::uint32_t color, bool two_sided = false);
    /// How much nearer a line is drawn than it is, so that the surface on which it lies does not hide it; and the same
    /// for what lies on that line.
    static constexpr float nearer = 1.004f;
    static constexpr float nearest = 1.008f;
    /// Where a line of at most this width between two points in camera coordinates is seen, in whichever band; nullopt
    /// if it is nowhere in the picture, or if an end is not finite or farther away than `farthest_m`.
    std::optional<DrawnLine> placedLine(Eigen::Vector3f from_m, Eigen::Vector3f to_m, int width_px) const;
    /// Draws as much of the line as lies in the band; the rest costs no time.
    void line(const DrawnLine& piece, std::uint32_t color, int width_px, float how_near = nearer);

private:
    template <class Wide>
    void fill(const DrawnCorner& a, const DrawnCorner& b, const DrawnCorner& c, std::uint32_t color);
    void dab(int x_px, int y_px, float nearness_per_m, std::uint32_t color, int width_px);

    ReliefPicture& picture_;
    PictureBand band_;
    float focal_px_;
    float middle_x_px_;
    float middle_y_px_;
};

} // namespace usar::mapping
