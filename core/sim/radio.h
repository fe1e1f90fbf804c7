// How strong one robot's radio is at another's: path loss over the distance, less what stands between (usarsim-protocol
// 6.2).
#pragma once

#include <string>

#include "core/base/geometry.h"
#include "core/sim/ray_caster.h"

namespace usar::sim {

/// The numbers of the wireless simulation server's obstacle model, which are those of the game's ComServer too. Those
/// without a counterpart there are ours, and say so.
struct RadioParameters {
    double reference_dbm = -49.67; ///< Pd0: strength at the reference distance
    double reference_m = 2.0;      ///< d0
    double exponent = 1.0;         ///< N: 1 is gentler than free space's 2, for walls do the rest
    double obstacle_db = 6.325;    ///< lost at each obstacle
    int most_obstacles = 5;        ///< more of them take no more
    double cutoff_dbm = -93.0;     ///< weaker is no link
    double nearest_m = 0.01;       ///< ours: closer counts as this far, so that no strength is infinite
    double antenna_height_m = 0.3; ///< ours: above the base, so that a pebble is no obstacle
    double solid_m = 10.0;         ///< ours: a hill is as many obstacles as it has stretches of this length
    double sample_m = 0.1;         ///< ours: gaps narrower than this are not found
    bool operator==(const RadioParameters&) const = default;
};

/// One radio, where its antenna is. Owned by nobody: a value of the moment.
struct RadioStation {
    std::string name;
    Vec3 antenna_in_map_m = Vec3::Zero();
    bool silent = false; ///< its battery is empty: nobody hears it, and it hears nobody
    bool operator==(const RadioStation&) const = default;
};

/// S = Pd0 - 10 N log10(dm / d0) - obstacles x attenuation.
double strengthOver(double distance_m, int obstacles, const RadioParameters& parameters = {});

/// Stretches of solid matter on the straight line: a wall, a tree (trunk and crown are one), a ridge of the ground; a
/// long stretch counts once more every `solid_m`. Water, robots and things that move do not count. The same both ways;
/// never more than `most_obstacles`.
int obstaclesBetween(const RayCaster& still, const Vec3& a_in_map_m, const Vec3& b_in_map_m,
                     const RadioParameters& parameters = {});

} // namespace usar::sim
