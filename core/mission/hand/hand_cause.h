// The prefix that distinguishes the sources of commands by hand from those of a behavior.
#pragma once

#include <string>
#include <string_view>

namespace usar::mission {

inline constexpr std::string_view hand_cause = "by hand: ";

/// Returns the source to name in a command's cause: "by hand: keys" for "keys".
inline std::string handCause(std::string_view what) {
    return std::string(hand_cause) += what;
}

/// True for a source made by `handCause`.
inline bool isHandCause(std::string_view source) {
    return source.starts_with(hand_cause);
}

} // namespace usar::mission
