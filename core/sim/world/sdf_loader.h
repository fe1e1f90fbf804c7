// Loads SDFormat files with our kind of error: file, line and reason in one value, nothing on the terminal.
#pragma once

#include <filesystem>

#include <sdf/Root.hh>

#include "core/base/result.h"

namespace usar::sim {

/// Fails for missing files, broken XML and anything that SDFormat does not allow. Callable from several threads, which
/// take turns, because libsdformat has one console per process. Include this header in readers only, so that
/// libsdformat's headers stay out of everyone else's way.
Result<sdf::Root> loadSdf(const std::filesystem::path& file);

} // namespace usar::sim
