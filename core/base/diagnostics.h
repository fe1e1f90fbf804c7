// Problems found while reading untrusted text, with their positions. The caller decides what follows from them.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace usar {

/// How bad a problem is: a Note needs no action, a Warning means that the result is usable but may differ from what was
/// meant, an Error means that something could not be read or done.
enum class Severity { Note, Warning, Error };

/// One problem. `offset` counts bytes from the start of the text that was read; `message` is a phrase for the operator.
struct Diagnostic {
    Severity severity = Severity::Warning;
    std::size_t offset = 0;
    std::string message;
    bool operator==(const Diagnostic&) const = default;
};

/// In the order in which the problems were found.
using Diagnostics = std::vector<Diagnostic>;

/// "warning at column 5: the closing brace is missing". Columns count from 1.
std::string toText(const Diagnostic& diagnostic);

} // namespace usar
