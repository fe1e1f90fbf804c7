// Several p-values that are looked at together.
#pragma once

#include <span>
#include <vector>

namespace usar::campaign {

/// Holm's adjusted p-values (Holm 1979), in the order given: whoever calls significant what is below 5 % here is wrong
/// anywhere in at most 5 % of all reports, however many questions a report asks.
std::vector<double> holm(std::span<const double> p_values);

} // namespace usar::campaign
