// Writes arbitrary bytes as printable quoted text, and reads them back.
#pragma once

#include <string>
#include <string_view>

namespace usar {

/// Appends `bytes` to `text` in double quotes. Quotes, backslashes and bytes that are not printable ASCII are escaped
/// as \n \r \t \\ \" or \xHH.
void appendQuoted(std::string& text, std::string_view bytes);
/// Removes a quoted text, and blanks before it, from the front of `rest` and decodes it into `bytes`. False if there is
/// no quoted text or it is malformed; then `rest` and `bytes` are unspecified.
bool takeQuoted(std::string_view& rest, std::string& bytes);

} // namespace usar
