// What was wrong with one piece of untrusted text, and where. The caller decides what follows from it.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace usar {

enum class Severity { Note, Warning, Error };

/// `offset` counts bytes from the start of the text that was read.
struct Diagnostic {
    Severity severity = Severity::Warning;
    std::size_t offset = 0;
    std::string message;
    bool operator==(const Diagnostic&) const = default;
};

using Diagnostics = std::vector<Diagnostic>;

std::string toText(const Diagnostic& diagnostic);

} // namespace usar
