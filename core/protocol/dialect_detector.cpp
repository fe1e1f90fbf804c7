#include "core/protocol/dialect_detector.h"

#include <algorithm>
#include <array>

#include "core/base/text.h"
#include "core/protocol/segments.h"

namespace usar::protocol {

namespace {

constexpr int most_belief = 8;
constexpr int least_belief = -4; ///< at this value the answer changes to the other dialect

/// Finds the first segment that begins at or after `from`, gives its key and value, and moves `from` to its end. False
/// if there is none.
bool nextSegment(std::string_view line, std::size_t& from, std::string_view& key, std::string_view& value) {
    const std::size_t open = line.find('{', from);
    if (open == std::string_view::npos)
        return false;
    const std::size_t close = std::min(line.find('}', open), line.size());
    std::string_view text = line.substr(open + 1, close - open - 1);
    key = takeWord(text);
    value = trimmed(text);
    from = close;
    return true;
}

bool hasKey(std::string_view line, std::string_view wanted) {
    std::string_view key;
    std::string_view value;
    for (std::size_t from = 0; nextSegment(line, from, key, value);) {
        if (sameWord(key, wanted))
            return true;
    }
    return false;
}

bool hasType(std::string_view line, std::string_view wanted) {
    std::string_view key;
    std::string_view value;
    for (std::size_t from = 0; nextSegment(line, from, key, value);) {
        if (sameWord(key, "Type"))
            return sameWord(value, wanted);
    }
    return false;
}

/// UT2004 begins an STA with its Type, UDK with its Time. An STA that begins otherwise is the answer to CONTROL GetSTA
/// and tells nothing.
std::optional<Dialect> byState(std::string_view line) {
    std::string_view key;
    std::string_view value;
    std::size_t from = 0;
    if (!nextSegment(line, from, key, value))
        return std::nullopt;
    if (sameWord(key, "Type"))
        return Dialect::Ut2004;
    return sameWord(key, "Time") ? std::optional(Dialect::Udk) : std::nullopt;
}

} // namespace

void DialectDetector::take(std::string_view line) {
    std::string_view rest = line.substr(0, line.find('{'));
    const std::string_view word = takeWord(rest);
    if (sameWord(word, "SEN"))
        return; // most lines; not characteristic of either dialect
    if (sameWord(word, "STA")) {
        if (const auto dialect = byState(line))
            vote(*dialect);
    } else if (sameWord(word, "RES") || (sameWord(word, "MISSTA") && hasKey(line, "Torque"))) {
        vote(Dialect::Ut2004);
    } else if (sameWord(word, "EFF") || sameWord(word, "ASTA") ||
               (sameWord(word, "CONF") && !asked_for_cameras_ && hasType(line, "Camera"))) {
        vote(Dialect::Udk);
    }
}

void DialectDetector::sent(const Command& command) {
    if (const auto* const asked = std::get_if<GetConfiguration>(&command))
        asked_for_cameras_ |= sameWord(asked->type, "Camera");
    else if (const auto* const raw = std::get_if<RawCommand>(&command))
        asked_for_cameras_ |= raw->line.find("Camera") != std::string::npos;
}

void DialectDetector::vote(Dialect dialect) {
    if (!dialect_)
        dialect_ = dialect;
    belief_ = std::min(belief_ + (dialect == *dialect_ ? 1 : -1), most_belief);
    if (belief_ > least_belief)
        return;
    dialect_ = dialect;
    belief_ = -belief_;
}

} // namespace usar::protocol
