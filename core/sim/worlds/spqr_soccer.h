// `spqr_soccer`: the field of a four-legged league with a loose ball.
#pragma once

#include <cstdint>

#include "core/sim/world/world.h"

namespace usar::sim {

/// Follows robots-and-worlds.md, section 5, "Procedural equivalents 4": a carpet of 6 m x 4 m inside boards 0.1 m high,
/// two goals at its ends, four beacons beside it, and a ball in its middle, on a floor of 12 m x 10 m. Nothing in it is
/// random: all seeds give the same world.
World makeSpqrSoccer(std::uint64_t seed);

inline constexpr double ball_radius_m = 0.043;

} // namespace usar::sim
