#include "core/posh/run/trace_event.h"

#include <array>

namespace usar::posh {

std::string_view toText(ActResult result) {
    constexpr std::array<std::string_view, 4> words{"Finished", "RunningOnce", "Running", "Failed"};
    return words[static_cast<std::size_t>(result)];
}

Value answerOf(const TraceRecord& record, std::string_view text) {
    switch (record.value) {
    case ValueKind::Nil:
        break;
    case ValueKind::Boolean:
        return record.payload != 0;
    case ValueKind::Integer:
        return static_cast<std::int64_t>(record.payload);
    case ValueKind::Real:
        return std::bit_cast<double>(record.payload);
    case ValueKind::Text:
        return std::string(text);
    case ValueKind::Symbol:
        return Symbol{std::string(text)};
    }
    return std::monostate{};
}

} // namespace usar::posh
