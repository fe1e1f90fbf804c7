// A world with everything that is made of it before its first robot comes.
#pragma once

#include <memory>

#include "core/base/result.h"
#include "core/sim/physics/physics.h"
#include "core/sim/rays/ray_caster.h"
#include "core/sim/world/world.h"

namespace usar::sim {

/// What rays and contacts are searched in takes longer to make than a world takes to read. A process that copies itself
/// for each simulation makes it once. Serves one simulation, and is empty when that has taken it.
class PreparedWorld {
public:
    /// Fails if there is nothing to stand on.
    static Result<PreparedWorld> make(World world);

    /// Both need a world that nobody has taken. The physics refers to the world, which must outlive it.
    std::shared_ptr<const StillWorld> takeStill();
    std::unique_ptr<Physics> takePhysics();

private:
    explicit PreparedWorld(World world);

    std::shared_ptr<const StillWorld> still_;
    std::unique_ptr<Physics> physics_;
};

} // namespace usar::sim
