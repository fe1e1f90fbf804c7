// Any bytes as one word of printable text, and back.
#pragma once

#include <string>
#include <string_view>

namespace usar {

/// In double quotes; what is not printable ASCII as \n \r \t \\ \" or \xHH.
void appendQuoted(std::string& text, std::string_view bytes);
/// Cuts a quoted text off the front of `rest`. False where there is none, or a broken one.
bool takeQuoted(std::string_view& rest, std::string& bytes);

} // namespace usar
