// The name of a type as written in the source code, for display and for files.
#pragma once

#include <string_view>

namespace usar {

/// The name without its namespaces: "RangeScan". Extracted from the function signature that GCC ("… [with T =
/// usar::RangeScan; …]") and Clang ("… [T = usar::RangeScan]") provide. Does not work for template instances, whose
/// arguments contain colons as well.
template <class T>
constexpr std::string_view typeName() {
    std::string_view text = __PRETTY_FUNCTION__;
    text.remove_prefix(text.find("T = ") + 4);
    text = text.substr(0, text.find_first_of(";]"));
    return text.substr(text.rfind(':') + 1);
}

} // namespace usar
