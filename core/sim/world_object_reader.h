// Movable things of a world file: models that are not static.
#pragma once

#include <filesystem>

#include <sdf/Model.hh>

#include "core/base/result.h"
#include "core/sim/world.h"

namespace usar::sim {

/// One link with a mass and collisions of box, sphere, cylinder or capsule, all of one surface. Errors name `file`, the
/// line and the reason.
Result<WorldObject> readObject(const sdf::Model& model, const std::filesystem::path& file);

} // namespace usar::sim
