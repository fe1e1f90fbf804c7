// A world and its ray caster: all that never changes while a simulation runs.
#pragma once

#include <utility>

#include "core/sim/rays/ray_caster.h"
#include "core/sim/world/world.h"

namespace usar::sim {

/// Immutable once made, so threads may share it. Cannot be moved, because the caster points to the world.
struct StillWorld {
    explicit StillWorld(World still) : world(std::move(still)), caster(world) {}
    StillWorld(const StillWorld&) = delete;
    StillWorld& operator=(const StillWorld&) = delete;

    World world;
    RayCaster caster;
};

} // namespace usar::sim
