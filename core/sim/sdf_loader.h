// libsdformat behind our kind of error: file, line and reason in one value, nothing on the terminal.
#pragma once

#include <filesystem>

#include <sdf/Root.hh>

#include "core/base/result.h"

namespace usar::sim {

/// Refuses missing files, broken XML and whatever SDFormat does not allow. libsdformat talks to one console per
/// process: load from one thread at a time. Included by readers only, so that its headers stay out of
/// everyone's way.
Result<sdf::Root> loadSdf(const std::filesystem::path& file);

} // namespace usar::sim
