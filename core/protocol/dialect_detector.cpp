#include "core/protocol/dialect_detector.h"

#include <algorithm>

#include "core/base/text.h"

namespace usar::protocol {

namespace {

constexpr int most_belief = 8;
constexpr int least_belief = -4; ///< at this value the answer changes to the other dialect

/// UT2004 begins an STA with its Type, UDK with its Time. An STA that begins otherwise is the answer to CONTROL GetSTA
/// and tells nothing.
std::optional<Dialect> byState(const Segments& line) {
    const std::string_view first = line.all().empty() ? std::string_view() : line.all().front().key;
    if (sameWord(first, "Type"))
        return Dialect::Ut2004;
    return sameWord(first, "Time") ? std::optional(Dialect::Udk) : std::nullopt;
}

} // namespace

void DialectDetector::take(std::string_view line) {
    std::string_view rest = line.substr(0, line.find('{'));
    const std::string_view word = takeWord(rest);
    if (sameWord(word, "SEN"))
        return; // most lines; not characteristic of either dialect
    segments_.read(line, ignored_);
    ignored_.clear();
    if (sameWord(word, "STA")) {
        if (const auto dialect = byState(segments_))
            vote(*dialect);
    } else if (sameWord(word, "RES") || (sameWord(word, "MISSTA") && segments_.find("Torque"))) {
        vote(Dialect::Ut2004);
    } else if (sameWord(word, "EFF") || sameWord(word, "ASTA") ||
               (sameWord(word, "CONF") && !asked_for_cameras_ && sameWord(segments_.value("Type"), "Camera"))) {
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
