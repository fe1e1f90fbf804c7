// The elements of a world file that SDFormat does not know, all named usar:...; resources/worlds/README.md lists them.
#pragma once

#include <filesystem>

#include <sdf/Element.hh>

#include "core/base/result.h"
#include "core/sim/world.h"

namespace usar::sim {

/// Adds what one child of the world element says to `world`; leaves SDFormat's own elements alone. `file` is the one
/// that the element was read from: errors name it, and tables are sought beside it.
Result<void> readMark(sdf::Element& element, const std::filesystem::path& file, World& world);

} // namespace usar::sim
