// A fast reader for the lists of numbers that scanners send.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace usar::protocol {

/// Replaces the content of `numbers` by the comma-separated list in `text`. A comma may follow the last element,
/// because UDK's imagers send one. An element that is not a number, is infinite or is too large for any sensor becomes
/// NaN. Returns how many elements were not clean numbers.
std::size_t readNumberList(std::string_view text, std::vector<double>& numbers);

} // namespace usar::protocol
