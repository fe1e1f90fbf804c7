// How the causes of commands by hand begin, so that they are told from those of a behavior.
#pragma once

#include <string>
#include <string_view>

namespace usar::mission {

inline constexpr std::string_view hand_cause = "by hand: ";

/// Source of a command's cause: "by hand: keys" for "keys".
inline std::string handCause(std::string_view what) {
    return std::string(hand_cause) += what;
}

/// True for a source that `handCause` has made.
inline bool isHandCause(std::string_view source) {
    return source.starts_with(hand_cause);
}

} // namespace usar::mission
