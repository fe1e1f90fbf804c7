// Which known word a misspelt one was meant to be.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace usar {

/// Letters (bytes) to change, put in or take out to make one word of the other.
std::size_t editDistance(std::string_view a, std::string_view b);

/// The first of the nearest; empty where nothing is known.
std::string nearestWord(std::string_view word, const std::vector<std::string>& known);

} // namespace usar
