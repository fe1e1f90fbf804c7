#include "core/mapping/relief/relief_scene.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <iterator>
#include <limits>
#include <system_error>
#include <thread>

#include "core/mapping/relief/relief_tiles.h"

namespace usar::mapping {

namespace {

std::uint32_t mixed(std::uint32_t from, std::uint32_t to, double part) {
    const auto channel = [&](int shift) {
        const double a = from >> shift & 0xff, b = to >> shift & 0xff;
        return static_cast<std::uint32_t>(a + (b - a) * part + 0.5) << shift;
    };
    return 0xff000000u | channel(16) | channel(8) | channel(0);
}

void clearBand(const ReliefScene& scene, ReliefPicture& picture, PictureBand band) {
    for (int row = 0; row < picture.height_px; ++row) {
        // The sky ends in the upper half, and below it is the color of unknown ground.
        const double part = std::min(1.0, 2.0 * (row + 0.5) / picture.height_px);
        const auto first = static_cast<std::ptrdiff_t>(picture.indexOf(band.first_px, row));
        const std::ptrdiff_t width = band.end_px - band.first_px;
        std::fill_n(picture.argb.begin() + first, width, mixed(scene.sky, scene.ground, part));
        std::fill_n(picture.nearness_per_m.begin() + first, width, 0.0f);
    }
}

/// NaN for a point so far away that single precision has no use.
Eigen::Vector3f cameraPoint(const ReliefProjection& projection, const Vec3& point_in_map_m) {
    const Vec3 at_m = projection.toCamera(point_in_map_m);
    if (!at_m.allFinite() || at_m.cwiseAbs().maxCoeff() > double(ReliefPen::farthest_m))
        return Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN());
    return at_m.cast<float>();
}

/// All bands of a picture share this, so that each of the many points of a trail is placed only once.
struct FramePlan {
    ReliefProjection projection;
    std::vector<std::vector<DrawnLine>> lines; ///< pieces of the scene's lines, in their order
};

int edgeWidth_px(const ReliefLine& line) {
    return line.width_px + (line.edge_color != 0 ? 2 : 0);
}

FramePlan planOf(const ReliefScene& scene, ReliefPicture& picture) {
    FramePlan plan{{scene.camera.limited(), picture.width_px, picture.height_px, scene.exaggeration}, {}};
    const ReliefPen pen(picture, plan.projection, {0, picture.width_px});
    for (const ReliefLine& line : scene.lines) {
        std::vector<DrawnLine>& pieces = plan.lines.emplace_back();
        Eigen::Vector3f before = Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN());
        for (const Vec3& point : line.points_in_map_m) {
            const Eigen::Vector3f at = cameraPoint(plan.projection, point);
            if (const auto piece = pen.placedLine(before, at, edgeWidth_px(line)))
                pieces.push_back(*piece);
            before = at;
        }
    }
    return plan;
}

void drawLine(const ReliefLine& line, const std::vector<DrawnLine>& pieces, ReliefPen& pen) {
    if (line.edge_color != 0)
        for (const DrawnLine& piece : pieces)
            pen.line(piece, line.edge_color, edgeWidth_px(line), ReliefPen::nearer);
    for (const DrawnLine& piece : pieces)
        pen.line(piece, line.color, line.width_px, ReliefPen::nearest);
}

/// The point itself, or the surface above it.
Vec3 raisedTo(const ReliefSurface& surface, Vec3 point_in_map_m) {
    if (const auto height_m = surface.height_m(point_in_map_m.head<2>()))
        point_in_map_m.z() = std::max(point_in_map_m.z(), double(*height_m));
    return point_in_map_m;
}

/// Into how many steps a straight stretch is divided, so that none is longer than a cell unless there are too many.
int stepsAlong(double length_m, double cell_size_m) {
    constexpr double most_steps = 4096.0;
    const double cells = std::ceil(length_m / cell_size_m);
    return cells > 1.0 ? static_cast<int>(std::min(cells, most_steps)) : 1; // NaN makes one step, too.
}

/// Corners of the solids in units of half a length: x forward, y left, z up.
constexpr std::array<std::array<double, 3>, 5> arrow{
    {{1.0, 0.0, 0.0}, {-0.8, 0.7, 0.0}, {-0.35, 0.0, 0.0}, {-0.8, -0.7, 0.0}, {-0.3, 0.0, 0.55}}};
constexpr std::array<std::array<double, 3>, 6> ball{
    {{0.6, 0.0, 0.0}, {0.0, 0.6, 0.0}, {-0.6, 0.0, 0.0}, {0.0, -0.6, 0.0}, {0.0, 0.0, 0.6}, {0.0, 0.0, -0.6}}};

/// A side of a solid: three corners, and how much black or white is mixed in.
struct Side {
    std::array<std::size_t, 3> corners;
    double light;
};
constexpr std::array<Side, 6> arrow_sides{{{{0, 1, 4}, 0.25},
                                           {{1, 2, 4}, -0.3},
                                           {{2, 3, 4}, -0.45},
                                           {{3, 0, 4}, -0.1},
                                           {{0, 2, 1}, -0.5},
                                           {{0, 3, 2}, -0.5}}};
constexpr std::array<Side, 8> ball_sides{{{{0, 1, 4}, 0.1},
                                          {{1, 2, 4}, 0.25},
                                          {{2, 3, 4}, 0.0},
                                          {{3, 0, 4}, -0.1},
                                          {{1, 0, 5}, -0.35},
                                          {{2, 1, 5}, -0.3},
                                          {{3, 2, 5}, -0.4},
                                          {{0, 3, 5}, -0.45}}};

/// How much nearer a body is drawn than it is; lines are drawn less near.
constexpr float nearer_than_lines = 1.012f;
static_assert(nearer_than_lines > ReliefPen::nearest);

template <std::size_t CornerCount, std::size_t SideCount>
void drawSolid(const ReliefBody& body, double half_m, const std::array<std::array<double, 3>, CornerCount>& corners,
               const std::array<Side, SideCount>& sides, const ReliefProjection& projection, ReliefPen& pen) {
    std::array<Eigen::Vector3f, CornerCount> at;
    const Eigen::Quaterniond rotation = body.in_map.rotation();
    for (std::size_t i = 0; i < CornerCount; ++i) {
        Vec3 corner_m = rotation * (half_m * Vec3(corners[i][0], corners[i][1], corners[i][2]));
        corner_m.z() /= projection.exaggeration(); // A robot is not as tall as its ground is drawn.
        // A point nearer on the same ray is seen at the same place: so a trail does not hide the robot that made it.
        at[i] = cameraPoint(projection, body.in_map.position_m + corner_m) / nearer_than_lines;
    }
    for (const Side& side : sides) {
        const std::uint32_t color =
            mixed(body.color, side.light < 0.0 ? 0xff000000u : 0xffffffffu, std::abs(side.light));
        pen.clippedTriangle({at[side.corners[0]], at[side.corners[1]], at[side.corners[2]]}, color, true);
    }
}

void drawBody(ReliefBody body, const ReliefScene& scene, const ReliefProjection& projection, ReliefPen& pen) {
    body.in_map.position_m = raisedTo(scene.surface, body.in_map.position_m);
    const auto seen = projection.project(body.in_map.position_m);
    if (!seen)
        return;
    const Vec2 below_m = body.in_map.position_m.head<2>();
    if (const auto ground_m = body.stalk ? scene.surface.height_m(below_m) : std::nullopt)
        if (const auto stalk =
                pen.placedLine(cameraPoint(projection, body.in_map.position_m),
                               cameraPoint(projection, {below_m.x(), below_m.y(), double(*ground_m)}), 1))
            pen.line(*stalk, body.color, 1);
    const double px_per_m = projection.focal_px() * seen->nearness_per_m;
    const double half_m = std::max(body.length_m, body.least_px / px_per_m) / 2.0;
    if (body.pointed)
        drawSolid(body, half_m, arrow, arrow_sides, projection, pen);
    else
        drawSolid(body, half_m, ball, ball_sides, projection, pen);
}

void drawBand(const ReliefScene& scene, const FramePlan& plan, ReliefPicture& picture, PictureBand band) {
    clearBand(scene, picture, band);
    ReliefPen pen(picture, plan.projection, band);
    drawSurface(scene.surface, plan.projection, scene.square_px, band, pen);
    for (std::size_t i = 0; i < scene.lines.size(); ++i)
        drawLine(scene.lines[i], plan.lines[i], pen);
    for (const ReliefBody& body : scene.bodies)
        drawBody(body, scene, plan.projection, pen);
}

} // namespace

void drawRelief(const ReliefScene& scene, ReliefPicture& picture, PictureBand band) {
    drawBand(scene, planOf(scene, picture), picture, band);
}

void drawReliefByStrips(const ReliefScene& scene, ReliefPicture& picture, int threads) {
    const FramePlan plan = planOf(scene, picture);
    // Strips go to whichever thread is free, because some show more of the map than others.
    const int strips = threads <= 1 ? 1 : 4 * threads;
    std::atomic<int> next = 0;
    const auto work = [&] {
        for (int strip = next++; strip < strips; strip = next++)
            drawBand(scene, plan, picture,
                     {picture.width_px * strip / strips, picture.width_px * (strip + 1) / strips});
    };
    std::vector<std::jthread> others;
    try {
        for (int i = 1; i < threads; ++i)
            others.emplace_back(work);
    } catch (const std::system_error&) {
        // The system has no more threads; those that there are draw all strips.
    }
    work();
}

ReliefPicture drawnRelief(const ReliefScene& scene, int width_px, int height_px, const std::stop_token& stop) {
    constexpr int strips = 8; // Between two of them it can stop.
    ReliefPicture picture(width_px, height_px);
    const FramePlan plan = planOf(scene, picture);
    for (int strip = 0; strip < strips; ++strip) {
        if (stop.stop_requested())
            return {};
        drawBand(scene, plan, picture, {width_px * strip / strips, width_px * (strip + 1) / strips});
    }
    return picture;
}

ReliefBody markBody(const Vec3& place_in_map_m, std::uint32_t color, int least_px) {
    return {.in_map = {place_in_map_m, 0.0, 0.0, 0.0},
            .color = color,
            .pointed = false,
            .length_m = 0.3,
            .least_px = least_px,
            .stalk = false};
}

std::vector<Vec3> pointsToShow(const ReliefScene& scene, std::span<const Rectangle> areas_in_map) {
    const std::vector<const ReliefTile*> tiles = tilesToShow(scene.surface, areas_in_map);
    std::vector<Vec3> points = someCorners(tiles, scene.surface.cell_size_m);
    const Rectangle bounds = boundsOf(tiles, scene.surface.cell_size_m);
    for (const ReliefLine& line : scene.lines)
        std::ranges::copy_if(line.points_in_map_m, std::back_inserter(points), [&](const Vec3& point) {
            const Vec2 place_m = point.head<2>();
            return bounds.contains(place_m) && scene.surface.height_m(place_m).has_value();
        });
    return points;
}

std::vector<Vec3> aboveSurface(const ReliefSurface& surface, const std::vector<Vec3>& points_in_map_m) {
    std::vector<Vec3> raised;
    raised.reserve(points_in_map_m.size());
    for (std::size_t i = 0; i < points_in_map_m.size(); ++i) {
        const Vec3& point = points_in_map_m[i];
        if (i > 0 && point.allFinite() && points_in_map_m[i - 1].allFinite()) {
            const Vec3 way_m = point - points_in_map_m[i - 1];
            const int steps = stepsAlong(way_m.head<2>().norm(), surface.cell_size_m);
            for (int step = 1; step < steps; ++step)
                raised.push_back(raisedTo(surface, points_in_map_m[i - 1] + way_m * (double(step) / steps)));
        }
        raised.push_back(raisedTo(surface, point));
    }
    return raised;
}

std::vector<Vec3> outlineOnSurface(const ReliefSurface& surface, const Rectangle& area_in_map) {
    if (area_in_map.empty())
        return {};
    const Vec2 low_m = area_in_map.min_m, high_m = area_in_map.max_m;
    const std::array<Vec2, 5> corners{low_m, {high_m.x(), low_m.y()}, high_m, {low_m.x(), high_m.y()}, low_m};
    std::vector<Vec3> points;
    std::optional<float> height_m;
    for (std::size_t side = 1; side < corners.size(); ++side) {
        const Vec2 way_m = corners[side] - corners[side - 1];
        const int steps = stepsAlong(way_m.norm(), surface.cell_size_m);
        for (int step = 0; step <= steps; ++step) {
            const Vec2 at_m = corners[side - 1] + way_m * (double(step) / steps);
            if (const auto known_m = surface.height_m(at_m))
                height_m = known_m;
            points.emplace_back(at_m.x(), at_m.y(), double(height_m.value_or(0.0f)));
        }
    }
    // The points before the first known height get that height, too.
    for (Vec3& point : points)
        if (const auto known_m = surface.height_m(point.head<2>())) {
            const double first_m = double(*known_m);
            for (Vec3* before = points.data(); before != &point; ++before)
                before->z() = first_m;
            break;
        }
    return points;
}

} // namespace usar::mapping
