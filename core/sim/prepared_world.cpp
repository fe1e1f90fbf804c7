#include "core/sim/prepared_world.h"

#include <cassert>
#include <utility>

namespace usar::sim {

Result<PreparedWorld> PreparedWorld::make(World world) {
    if (world.terrain.empty() && world.boxes.empty())
        return failure("there is nothing to stand on", "world '" + world.name + "'", "Give it a height map or boxes");
    return PreparedWorld(std::move(world));
}

PreparedWorld::PreparedWorld(World world)
    : still_(std::make_shared<const StillWorld>(std::move(world)))
    , physics_(makePhysics(still_->world)) {}

std::shared_ptr<const StillWorld> PreparedWorld::takeStill() {
    assert(still_);
    return std::move(still_);
}

std::unique_ptr<Physics> PreparedWorld::takePhysics() {
    assert(physics_);
    return std::move(physics_);
}

} // namespace usar::sim
