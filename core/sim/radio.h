// Signal strength of one robot's radio at another's: path loss over the distance, minus the loss at what stands in
// between (protocol.md 6.2).
#pragma once

#include <string>

#include "core/base/geometry.h"
#include "core/sim/rays/ray_caster.h"

namespace usar::sim {

/// Parameters of the wireless simulation server's obstacle model, which the game's ComServer uses too. Those marked as
/// ours have no counterpart there.
struct RadioParameters {
    double reference_dbm = -49.67; ///< Pd0: strength at the reference distance
    double reference_m = 2.0;      ///< d0
    double exponent = 1.0;         ///< N: 1 is gentler than free space's 2, because walls do the rest
    double obstacle_db = 6.325;    ///< lost at each obstacle
    int most_obstacles = 5;        ///< further obstacles take nothing away
    double cutoff_dbm = -93.0;     ///< below this there is no link
    double nearest_m = 0.01;       ///< ours: shorter distances count as this one, so that no strength is infinite
    double antenna_height_m = 0.3; ///< ours: height above the base, so that a pebble is no obstacle
    double solid_m = 10.0;         ///< ours: a solid stretch counts as one more obstacle per such length, as in a hill
    double sample_m = 0.1;         ///< ours: gaps narrower than this are not found
    bool operator==(const RadioParameters&) const = default;
};

/// One radio and the position of its antenna, at one moment.
struct RadioStation {
    std::string name;
    Vec3 antenna_in_map_m = Vec3::Zero();
    bool silent = false; ///< its battery is empty: it neither sends nor receives
    bool operator==(const RadioStation&) const = default;
};

/// Received strength in dBm: S = Pd0 - 10 N log10(dm / d0) - obstacles x attenuation.
double strengthOver(double distance_m, int obstacles, const RadioParameters& parameters = {});

/// Counts stretches of solid matter on the straight line: a wall, a tree (trunk and crown are one), a ridge of the
/// ground; a long stretch counts once more every `solid_m`. Water, robots and movable things do not count. The result
/// is the same both ways and at most `most_obstacles`.
int obstaclesBetween(const RayCaster& still, const Vec3& a_in_map_m, const Vec3& b_in_map_m,
                     const RadioParameters& parameters = {});

} // namespace usar::sim
