// Parts that generated worlds are built from: numbers that files keep exactly, grounds, trees, blocks.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/random.h"
#include "core/sim/world/world.h"

namespace usar::sim {

/// Sorts points into buckets over the square +-`half_m`, which all of them must be inside of. Meters.
class Spacing {
public:
    explicit Spacing(double half_m);

    void add(const Vec2& point_m);
    /// True if no point is closer than `distance_m`.
    bool isClear(const Vec2& point_m, double distance_m) const;

private:
    std::ptrdiff_t bucketOf(double coordinate_m) const;

    double half_m_;
    std::ptrdiff_t side_;
    std::vector<std::vector<Vec2>> buckets_;
};

/// Rounds to 1/1000.
double wholeMillimetres(double value_m);
/// A uniformly distributed random number, in whole millimeters.
double between(Random& random, double low_m, double high_m);

/// The rectangular grid of posts that a ground is made of, centered on the map's origin.
struct PostGrid {
    std::size_t columns = 0;
    std::size_t rows = 0;
    double step_m = 1.0;
    /// Heights are rounded to whole steps; see world_writer.h for the relief that each value allows.
    double steps_per_m = 1024.0;
};

/// Samples a height function of the place at all posts, in whole steps.
Terrain terrainOf(const PostGrid& grid, const std::function<double(const Vec2&)>& height_m);

/// The lowest ground at the center of a circle and on the circle, rounded down to whole millimeters.
double lowestGround_m(const Terrain& terrain, const Vec2& at_m, double radius_m);

/// The lowest and the highest ground at nine points of a rectangle: its corners, its center, and between them.
struct GroundRange {
    double lowest_m = 0.0;
    double highest_m = 0.0;
};
/// The ground under a rectangle of this size, which is turned by the yaw about its center.
GroundRange groundUnder(const Terrain& terrain, const Vec2& center_m, const Vec2& size_m, double yaw_rad);

/// A tree of random size, rooted so deep that no slope leaves a gap under the trunk's lower side. Trees are tall enough
/// for an AirRobot to find crowns when it scans 6 m above ground.
Plant makeTree(Random& random, const Terrain& terrain, const Vec2& at_m);

/// Adds `wanted` plants one by one where `tryOne` finds a place, and their positions to `trunks`. Gives up after
/// `most_tries` calls of `tryOne`, which is far above the number needed.
void scatter(World& world, Spacing& trunks, int wanted, int most_tries,
             const std::function<std::optional<Plant>()>& tryOne);

/// Eight points on a circle, evenly spaced from the x axis on.
std::array<Vec2, 8> ringAround(const Vec2& center_m, double radius_m);

/// The upright box between its lowest and its highest corner.
Box block(const Vec3& low_m, const Vec3& high_m);

/// Closes a hall of this size inside, around the map's origin, with a level floor, four walls and a roof. They replace
/// the world's ground and boxes.
void buildHall(World& world, const Vec3& size_m);

/// A straight bar from one point to another, whose axis is the line between them. Its width is measured on the level,
/// its thickness across the line and the width. The line must not be vertical.
Box beam(const Vec3& from_m, const Vec3& to_m, double width_m, double thickness_m);
/// A ramp, a roof or a ledge: like `beam`, but the line runs in its upper face.
Box slab(const Vec3& from_m, const Vec3& to_m, double width_m, double thickness_m);

/// A place where robots appear; the ground around it is level and open.
struct StartPlace {
    std::string name;
    Vec2 at_m = Vec2::Zero();
    double yaw_rad = 0.0;
};

/// Height of a start pose above the ground, which leaves a little air below an AirRobot's legs.
inline constexpr double spawn_height_m = 0.35;

/// The start pose above ground of this height, rounded to numbers that files keep exactly.
NamedPose startOver(const StartPlace& place, double ground_z_m);
/// Adds start poses above the world's terrain.
void addStarts(World& world, const std::vector<StartPlace>& places);
/// True if the point is farther than `distance_m` from every one of the places.
bool isFarFrom(const std::vector<StartPlace>& places, const Vec2& point_m, double distance_m);

/// The point with the highest `score` on a square grid of posts `step_m` apart within +-`half_m`. A point without a
/// score is not a candidate; if there is none, the result is the origin.
Vec2 bestOnGrid(double half_m, double step_m, const std::function<std::optional<double>(const Vec2&)>& score);

/// Yaw of a robot at `from_m` that faces `to_m`.
double yawToward(const Vec2& from_m, const Vec2& to_m);

} // namespace usar::sim
