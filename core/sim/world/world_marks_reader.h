// Reads the elements of a world file that SDFormat does not know, all named usar:...; resources/worlds/README.md lists
// them.
#pragma once

#include <filesystem>

#include <sdf/Element.hh>

#include "core/base/result.h"
#include "core/sim/world/world.h"

namespace usar::sim {

/// Adds what one child of the world element says to `world`; ignores SDFormat's own elements and fails for unknown
/// usar: ones. `file` is the file that the element was read from: errors name it, and tables are looked for next to it.
Result<void> readMark(sdf::Element& element, const std::filesystem::path& file, World& world);

} // namespace usar::sim
