// Lists of numbers as scanners send them, at the speed of the plain decimals that they are.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace usar::protocol {

/// Replaces what is in `numbers` by the list with commas in `text`; one more comma may follow the last element, as
/// UDK's imagers send it. What is no number, is infinite, or is too large for any sensor is NaN. Gives how many
/// elements were not clean.
std::size_t readNumberList(std::string_view text, std::vector<double>& numbers);

} // namespace usar::protocol
