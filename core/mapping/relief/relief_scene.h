// The scene that a view of the relief shows, and the functions that draw it.
#pragma once

#include <span>
#include <stop_token>
#include <vector>

#include "core/mapping/relief/relief_picture.h"
#include "core/mapping/relief/relief_surface.h"

namespace usar::mapping {

/// How the name of a mission's picture in perspective ends; what is before it is the stem of all its files.
inline constexpr char relief_picture_ending[] = "_3d.png";

/// A line through points of the map; a point of NaN makes a gap. Colors are 0xffRRGGBB.
struct ReliefLine {
    std::vector<Vec3> points_in_map_m;
    std::uint32_t color = 0xffffffffu;
    std::uint32_t edge_color = 0; ///< color of a thin edge on both sides; 0 if it has none
    int width_px = 2;
};

/// A trail breaks where two of its points are farther apart than this, because no robot goes as far between two of its
/// messages: it was moved, or a position was garbled.
inline constexpr double longest_trail_step_m = 10.0;

/// A body is drawn as a solid arrow, or as a ball-like mark of a place without direction. It is never smaller than
/// `least_px`, so that it is seen from afar, and it is drawn on the surface if its place lies below it.
struct ReliefBody {
    Pose in_map{};
    std::uint32_t color = 0xffffffffu;
    bool pointed = true; ///< false: it has no direction
    double length_m = 0.5;
    int least_px = 18;
    bool stalk = true; ///< a thin line goes down to the surface
    bool operator==(const ReliefBody&) const = default;
};

/// The body of a mark that is no smaller than this in the picture.
ReliefBody markBody(const Vec3& place_in_map_m, std::uint32_t color, int least_px);

/// A plain value; the surface's tiles are shared.
struct ReliefScene {
    ReliefSurface surface{};
    std::vector<ReliefLine> lines{};
    std::vector<ReliefBody> bodies{};
    OrbitCamera camera{};
    double exaggeration = 1.0;
    std::uint32_t sky = 0xff8090a0u;    ///< at the upper edge of the picture
    std::uint32_t ground = 0xff202830u; ///< at the lower edge, and where nothing is known
    /// A tile is drawn in the finest level whose squares are not smaller than about this; 0: all squares.
    double square_px = 2.0;
};

/// Draws one band of the picture, which must have a size; what was in it goes. Pure and repeatable: the bands of a
/// picture may be drawn by several threads, and look the same however it is divided. Without lines, the time depends on
/// the size of the picture rather than on that of the map.
void drawRelief(const ReliefScene& scene, ReliefPicture& picture, PictureBand band);

/// Draws all of the picture in this many threads, of which the calling one is the first; in fewer if the system has no
/// more.
void drawReliefByStrips(const ReliefScene& scene, ReliefPicture& picture, int threads);

/// The whole picture in one go, in the calling thread; empty after a request to stop.
ReliefPicture drawnRelief(const ReliefScene& scene, int width_px, int height_px, const std::stop_token& stop = {});

/// The points that a camera which shows all must have in its picture: those tiles of the surface that tilesToShow()
/// tells, and the lines above them.
std::vector<Vec3> pointsToShow(const ReliefScene& scene, std::span<const Rectangle> areas_in_map);

/// A way over the map, raised to the surface where it would pass below it, as the way of a robot on the ground does.
/// Points are put in between, so that there is at least one per cell, but at most 4096 in a straight stretch.
std::vector<Vec3> aboveSurface(const ReliefSurface& surface, const std::vector<Vec3>& points_in_map_m);

/// The outline of a rectangle, lying on the surface; where nothing is known it goes on at the last known height. It has
/// as many points as aboveSurface() makes of its sides.
std::vector<Vec3> outlineOnSurface(const ReliefSurface& surface, const Rectangle& area_in_map);

} // namespace usar::mapping
