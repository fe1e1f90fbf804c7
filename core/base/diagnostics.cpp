#include "core/base/diagnostics.h"

namespace usar {

std::string toText(const Diagnostic& diagnostic) {
    static constexpr const char* words[] = {"note", "warning", "error"};
    return std::string(words[static_cast<int>(diagnostic.severity)]) + " at column " +
           std::to_string(diagnostic.offset + 1) + ": " + diagnostic.message;
}

} // namespace usar
