// A local memory of obstacles around the robot: what the belly scanner saw, and fading sonar echoes.
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "core/base/clock.h"
#include "core/base/geometry.h"
#include "robots/airrobot/flight/moving_grid.h"
#include "robots/airrobot/flight/senses.h"

namespace usar::airrobot {

/// An obstacle, in the map frame.
struct Obstacle {
    Vec2 at_m = Vec2::Zero();
    double top_m = 0.0;     ///< map z of the highest part that was seen
    bool top_known = false; ///< false if only a sonar saw it; then it may be higher
};

/// How long scanner hits and sonar echoes are remembered.
struct MemorySpans {
    Seconds scan{600.0};
    Seconds sonar{20.0};
    double below_m = 1e9; ///< map z; higher hits are on a ceiling
    /// Keeps of an echo what is below later beams that pass over it from nearer, and all of it until there were some:
    /// crowns have thin tips, which sonars hear once in a while. Otherwise the first one removes it, which is right for
    /// walls and racks.
    bool lower_parts = false;
    /// In a room, a cell that is seen again shows another part of a rack more often than a drift of the height.
    bool in_room = false;
};

/// Prevents the two ways in which the thesis's robot crashed (4.6): flying backward without seeing, and sinking onto
/// peaks. A grid that moves along with the robot stores the highest scanner hit of each cell. Sonar echoes are points
/// that expire. A later beam that passes through one removes it, or leaves the part below (see MemorySpans). Works in
/// the map frame and drifts with the INS, so it must be cleared when the INS is reset. Owned by one robot.
class ObstacleMemory {
public:
    static constexpr double cell_m = grid_cell_m; ///< size of a cell
    static constexpr int side = 256;              ///< cells per side of the grid, which is 128 m

    ObstacleMemory();

    /// Adds the scan and the sonar echoes of a tick.
    void take(const Senses& senses, const MemorySpans& spans);
    /// Adds something that the robot has touched, which may be too thin for its sensors.
    void touch(const Vec3& at_m) { takeScan({&at_m, 1}, std::numeric_limits<double>::infinity()); }
    void clear();
    /// Forgets what was not seen within `fresh`, and of the rest how high it once was.
    void keepFresh(Seconds fresh);

    /// Returns the obstacles within `radius_m` of `at_m` whose top is above `level_m` (map z).
    std::vector<Obstacle> near(const Vec2& at_m, double radius_m, double level_m) const;
    /// Returns the highest top in the disc that is below `below_m` (both map z), including sonar echoes; nullopt if
    /// none is known.
    std::optional<double> highest_m(const Vec2& at_m, double radius_m,
                                    double below_m = std::numeric_limits<double>::infinity()) const;
    /// Returns the highest scanner hit in a corridor of `length_m` that starts at `from_m`; nullopt if none is known.
    /// The bearing is in the map frame.
    std::optional<double> highestAlong_m(const Vec2& from_m, double bearing_rad, double half_width_m,
                                         double length_m) const;
    /// Returns the middles of the cells in the disc that the scanner has seen, as high as their tops.
    std::vector<Vec3> tops_m(const Vec2& at_m, double radius_m) const;
    /// The same of cells that were seen within `fresh`, as high as they were then. Older tops were seen with another
    /// drift: where the ground falls off, they hide the brink.
    std::vector<Vec3> freshTops_m(const Vec2& at_m, double radius_m, Seconds fresh) const;
    /// How much higher the ground is now than when the robot passed over it some time ago: so much has the estimate of
    /// the height drifted since then, and so much higher is what else was seen there. The median of the cells that were
    /// seen again within seconds, as it was half a minute ago at most; 0 if they were few, and in a room.
    double risen_m() const;
    /// The same as `tops_m`, with what was seen some time ago moved by `risen_m`.
    std::vector<Vec3> risenTops_m(const Vec2& at_m, double radius_m) const;
    /// Returns the highest top of a mast in the disc that is between the two heights (map z); nullopt if none is known.
    /// A mast is something as narrow as a cell that stands out from what is around it by more than crowns of trees do
    /// from their trunks.
    std::optional<double> highestMast_m(const Vec2& at_m, double radius_m, double above_m, double below_m) const;
    /// Returns the lowest cell in the disc that the scanner has seen; nullopt if none is known.
    std::optional<double> lowest_m(const Vec2& at_m, double radius_m) const;
    /// Returns the share of the corridor's cells that the scanner has seen, 0 to 1; 0 if something in it reached up to
    /// the scanner when it was seen, because that goes on above, and nobody knows how far.
    double knownAlong(const Vec2& from_m, double bearing_rad, double half_width_m, double length_m) const;

private:
    struct Cell {
        int column = 0;
        int row = 0;
        float top_m = 0.0f;
        float time_s = -1e9f;   ///< when that was seen
        float last_m = 0.0f;    ///< highest hit of the newest scan that has reached it
        float last_s = -1e9f;   ///< time of that scan
        float recent_m = 0.0f;  ///< highest hit of the last seconds
        float recent_s = -1e9f; ///< time of that hit
        bool goes_on = false;   ///< see mayGoOn()
    };
    struct Echo {
        Vec3 at_m;          ///< its z is the highest that the obstacle can be
        double low_m = 0.0; ///< and this the lowest
        Seconds time;
        int passed = 0; ///< beams that went over a part of it
    };

    /// A cell that was seen again after some time, and how much higher it was.
    struct SeenAgain {
        Seconds time;
        double risen_m;
    };

    /// Heights are map z; `scanner_m` is infinite for what no scanner saw.
    void takeScan(std::span<const Vec3> hits_m, double scanner_m);
    void noteRise();
    double risenWithin_m(Seconds span) const; ///< 0 if that was measured longer ago
    void takeEcho(const SonarEcho& echo);
    bool isMast(const Cell& cell) const;
    /// Returns nullptr if the cell is unknown or too old.
    const Cell* known(int column, int row) const;
    /// Calls `visit(center_m, cell)` for each cell with its center in the disc; `cell` is nullptr if unknown.
    template <class Visit>
    void visitDisc(const Vec2& at_m, double radius_m, Visit&& visit) const;

    std::vector<Cell> cells_;
    std::vector<Echo> echoes_;
    std::vector<SeenAgain> seen_again_;   ///< in the last seconds
    SeenAgain risen_{Seconds(-1e9), 0.0}; ///< the last median of enough cells
    MemorySpans spans_;
    Seconds now_{0.0};
};

/// Returns the length of the free way from `from_m` along `bearing_rad` (map frame) for a body with `half_width_m` to
/// each side; `reach_m` if there are no obstacles within that distance.
double clearance_m(std::span<const Obstacle> obstacles, const Vec2& from_m, double bearing_rad, double half_width_m,
                   double reach_m);
/// Returns the distance to the nearest obstacle, at most `otherwise_m`.
double nearest_m(std::span<const Obstacle> obstacles, const Vec2& from_m, double otherwise_m);

} // namespace usar::airrobot
