// What stands in the way at flying height, kept for a whole sortie, and ways around it.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "core/base/geometry.h"
#include "robots/airrobot/flight/moving_grid.h"
#include "robots/airrobot/flight/senses.h"

namespace usar::airrobot {

/// What ends farther than this below the robot's base passes below it.
inline constexpr double passes_below_m = 1.2;
/// The same for a robot that can get no higher, as below a ceiling.
inline constexpr double passes_closer_m = 0.8;

/// Heights from the lowest to the highest one, map z.
struct HeightBand {
    double low_m = 0.0;
    double high_m = 0.0;
};

/// Knows to which places ways lead.
class ReachablePlaces {
public:
    ReachablePlaces() = default;
    /// `inside`: by row and column, from the cell with the lowest ones, in a square.
    ReachablePlaces(int column, int row, std::vector<bool> inside)
        : column_(column)
        , row_(row)
        , inside_(std::move(inside)) {}
    /// True also beyond the square, of which nothing is known.
    bool contains(const Vec2& at_m) const;
    /// True within the square.
    bool knows(const Vec2& at_m) const;
    /// True if a way leads to within `within_m` of the place; true also if nothing is known of some place there.
    bool leadsNear(const Vec2& at_m, double within_m) const;

private:
    int column_ = 0;
    int row_ = 0;
    std::vector<bool> inside_;
};

/// The space that a way needs. A robot that must get home goes through narrower places than one that could as well
/// leave out a goal.
enum class Width { Usual, Least };

/// The steering sees a few meters and knows no dead ends. This map is for them: it finds the way around a wall, or that
/// there is none. What nobody has seen counts as free, so a way that leads there is an invitation to look. A grid that
/// moves along with the robot, in the map frame of its own estimate: clear it when the INS was set. Owned by one robot.
class RouteMap {
public:
    static constexpr int side = 512; ///< cells per side of the grid, which is 256 m

    RouteMap();

    /// Sets how far below the robot's base a thing must end to pass below it, from now on.
    void passOver(double below_m) { passes_below_m_ = below_m; }
    /// Adds the robot's place and what the sensors saw in this tick below `below_m` (map z), where the ceiling begins.
    void take(const Senses& senses, double below_m);
    /// Adds what a scan saw at the heights of `band`, at which the robot does not fly. A place there is closed if more
    /// beams end in it than pass through: the drift of the pose draws a wall beside its place as well, and would close
    /// every door in time.
    void takeBand(const PlacedScan& scan, const HeightBand& band);
    /// Adds an obstacle that reaches the height `z_m` (map z), because the robot does not get past that place.
    void block(const Vec2& at_m, double z_m);
    void clear();
    /// True if the robot has been there or within its half width of it.
    bool wasFlown(const Vec2& at_m) const;

    /// The way from one place to another at the height `z_m` (map z), as points half a meter apart. It ends within
    /// `within_m` of the goal, or where the map ends on the way there. nullopt: there is no way.
    std::optional<std::vector<Vec2>> route(const Vec2& from_m, const Vec2& to_m, double z_m, double within_m,
                                           Width width = Width::Usual) const;
    /// All places to which ways lead at this height.
    ReachablePlaces reach(const Vec2& from_m, double z_m, Width width = Width::Usual) const;
    /// True if nothing known that reaches the height `z_m` (map z) stands within `radius_m`.
    bool hasRoom(const Vec2& at_m, double z_m, double radius_m) const;
    /// True if ground that is not higher than `floor_m` (map z) was seen everywhere within `radius_m`.
    bool isOpenGround(const Vec2& at_m, double radius_m, double floor_m) const;
    /// The nearest place to `from_m`, with room around it if there is one, on ground not higher than `floor_m` (map z)
    /// that can be reached at the height `z_m`, and that is `beyond_m` or more from all `other` places; nullopt if less
    /// of such ground was seen than a robot needs to stand on.
    std::optional<Vec2> groundBeyond_m(const Vec2& from_m, double z_m, double floor_m, const ReachablePlaces& other,
                                       double beyond_m) const;
    /// True if nothing known stands within the robot's half width of the straight line. On the first meters less is
    /// enough, because the robot may be near something already.
    bool isStraightWayFree(const Vec2& from_m, const Vec2& to_m, double z_m) const;
    /// True if nothing known that reaches the height `z_m` (map z) stands between the places. What stands at `to_m`
    /// does not count.
    bool isInSight(const Vec2& from_m, const Vec2& to_m, double z_m) const;

private:
    struct Cell {
        std::int16_t column = 0;
        std::int16_t row = 0;
        float top_m = -1e9f;  ///< highest scanner hit, map z
        float echo_m = -1e9f; ///< height of the last sonar echo; what beams have passed through since is removed
        bool flown = false;
        std::uint8_t ended = 0;  ///< beams that ended in it within the band of takeBand()
        std::uint8_t passed = 0; ///< and that passed through it

        /// How high something stands there; that of ground if beams pass through what was seen there once.
        float height_m() const { return std::max(passed > ended ? -1e9f : top_m, echo_m); }
    };

    Cell& at(int column, int row);
    bool blocked(int column, int row, double level_m) const;
    /// A question about cells: does something stand there that ends less than some way below `z_m` (map z)?
    auto blockedAt(double z_m) const;
    void takeScan(const PlacedScan& scan, double below_m);
    void takeEcho(const SonarEcho& echo);
    /// Notes where the beam from one place to another one passes through the band, the last cell left out.
    void passThrough(const Vec3& from_m, const Vec3& to_m, const HeightBand& band);
    /// By cell of a square around the place, row by row: something stands nearer than `needed_m`. The way off a place
    /// next to which something stands is not closed.
    std::vector<bool> closedAround(const Vec2& from_m, double z_m, double needed_m) const;

    std::vector<Cell> cells_;
    double passes_below_m_ = passes_below_m;
};

} // namespace usar::airrobot
