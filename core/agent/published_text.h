// Converts published values to texts for a recording, and back (resources/docs/recording-format.md, "Published
// values").
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/agent/published.h"

namespace usar::agent {

/// Appends the text of a value. Numbers read back as the same double; infinities become NaN.
void appendText(std::string& text, const Published& value);
/// Reads such a text; nullopt if this version does not know its first word or its structure.
std::optional<Published> readPublished(std::string_view text);

} // namespace usar::agent
