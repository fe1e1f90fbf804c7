// A local memory of what stands around the robot: what the belly scanner saw, and fading sonar echoes.
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "core/base/clock.h"
#include "core/base/geometry.h"
#include "robots/airrobot/senses.h"

namespace usar::airrobot {

/// A thing that reaches the flight level. `top_m` is the highest part seen; what only a sonar saw may be higher.
struct Obstacle {
    Vec2 at_m = Vec2::Zero();
    double top_m = 0.0;
    bool top_known = false;
};

/// How long things are remembered.
struct MemorySpans {
    Seconds scan{600.0};
    Seconds sonar{20.0};
};

/// Cures the two ways in which the thesis's robot fell (4.6): reversing blind and sinking onto tips. A grid of
/// `cell_m` that rolls with the robot keeps the highest scanner hit of each cell; sonar echoes are points that fade, or
/// go when a later beam passes through them. Map frame; drifts with the INS, so it is cleared when that is reset.
/// Owned by one robot.
class ObstacleMemory {
public:
    static constexpr double cell_m = 0.5;
    static constexpr int side = 256; ///< cells: 128 m

    ObstacleMemory();

    void take(const Senses& senses, const MemorySpans& spans);
    void clear();

    /// Things within `radius_m` of `at_m` whose top is over `level_m`.
    std::vector<Obstacle> near(const Vec2& at_m, double radius_m, double level_m) const;
    /// The highest thing in the disc whose top is under `below_m`, sonar echoes included; nothing where none is known.
    std::optional<double> highest_m(const Vec2& at_m, double radius_m,
                                    double below_m = std::numeric_limits<double>::infinity()) const;
    /// The same in a corridor of `length_m` that starts at `from_m`; scanner hits only.
    std::optional<double> highestAlong_m(const Vec2& from_m, double bearing_rad, double half_width_m,
                                         double length_m) const;
    /// The lowest thing in the disc.
    std::optional<double> lowest_m(const Vec2& at_m, double radius_m) const;
    /// Part of the corridor's cells that the scanner has seen, 0..1.
    double knownAlong(const Vec2& from_m, double bearing_rad, double half_width_m, double length_m) const;

private:
    struct Cell {
        int column = 0;
        int row = 0;
        float top_m = 0.0f;
        float time_s = -1e9f;
    };
    struct Echo {
        Vec3 at_m;
        Seconds time;
    };

    void takeScan(std::span<const Vec3> hits_m);
    void takeEcho(const SonarEcho& echo);
    /// nullptr where unknown or forgotten.
    const Cell* known(int column, int row) const;
    template <class Visit>
    void visitDisc(const Vec2& at_m, double radius_m, Visit&& visit) const;

    std::vector<Cell> cells_;
    std::vector<Echo> echoes_;
    MemorySpans spans_;
    Seconds now_{0.0};
};

/// Free way from `from_m` along `bearing_rad` for a body `half_width_m` wide to each side; `reach_m` if all is free.
double clearance_m(std::span<const Obstacle> obstacles, const Vec2& from_m, double bearing_rad, double half_width_m,
                   double reach_m);
/// Distance to the nearest obstacle, or `otherwise_m`.
double nearest_m(std::span<const Obstacle> obstacles, const Vec2& from_m, double otherwise_m);

} // namespace usar::airrobot
