// Which sensors report all the time, and which only if they detect something.
#pragma once

#include <string_view>

namespace usar::protocol {

/// False for sensor types that send nothing while there is nothing to report (protocol.md 4.5), so that their silence
/// means nothing; true for all others, also for unknown ones. Ignores case. Such a type says so in its own struct:
/// `static constexpr bool speaks_always = false`.
bool speaksAlways(std::string_view wire_type);

} // namespace usar::protocol
