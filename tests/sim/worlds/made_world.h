// Worlds of many seeds for tests, and questions about their boxes.
#pragma once

#include <string>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/random.h"
#include "core/sim/world/world.h"

namespace usar::sim {

inline constexpr int made_seeds = 20;                 ///< of each world, from 1 on
inline constexpr double steepest_rad = radians(15.0); ///< what a P2DX must be able to climb

/// The world of this seed, which is made once a program.
const World& madeWorld(const std::string& name, int seed);
/// Adds a column and a row for each seed to the table of a test.
void addSeeds();

Vec3 randomDirection(Random& random);
/// The place of a start pose that must exist.
const Vec3& startOf(const World& world, const char* name);

/// True if the box is turned about the vertical at most.
bool isTurnedLevel(const Box& box);
/// True if the box is not turned at all.
bool isUpright(const Box& box);
/// A point of the box, whose sides are at -1 and 1.
Vec3 pointOf(const Box& box, double x, double y, double z);
/// Nine points of the lower or upper face, those at the border 1 cm inside of it.
std::vector<Vec3> pointsOfFace(const Box& box, double z);
/// True if the ground or another box of the world is right under a part of it.
bool isSupported(const World& world, const Box& box);
/// True if another box touches one of its ends or sides, as posts hold a shelf.
bool isHeld(const World& world, const Box& box);

} // namespace usar::sim
