// The name of a type as it is written in the source, for people and files.
#pragma once

#include <string_view>

namespace usar {

/// Without its namespaces: "RangeScan". From what GCC and Clang say of a function, "… [with T = usar::RangeScan; …]"
/// and "… [T = usar::RangeScan]"; not for templates, whose arguments have colons as well.
template <class T>
constexpr std::string_view typeName() {
    std::string_view text = __PRETTY_FUNCTION__;
    text.remove_prefix(text.find("T = ") + 4);
    text = text.substr(0, text.find_first_of(";]"));
    return text.substr(text.rfind(':') + 1);
}

} // namespace usar
