// Published values as texts for a recording, and back (resources/docs/recording-format.md, "Published values").
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/agent/published.h"

namespace usar::agent {

/// Numbers read back to the same double; infinities become NaN.
void appendText(std::string& text, const Published& value);
/// Nothing for a word or a shape that this program does not know.
std::optional<Published> readPublished(std::string_view text);

} // namespace usar::agent
