// Reads the movable objects of a world file: models that are not static.
#pragma once

#include <filesystem>

#include <sdf/Model.hh>

#include "core/base/result.h"
#include "core/sim/world/world.h"

namespace usar::sim {

/// The model must be one link with a mass and with collisions of box, sphere, cylinder or capsule, all of one surface.
/// An error names `file`, the line and the reason.
Result<WorldObject> readObject(const sdf::Model& model, const std::filesystem::path& file);

} // namespace usar::sim
