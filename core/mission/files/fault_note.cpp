#include "core/mission/files/fault_note.h"

#include <algorithm>

#include "core/base/numbers.h"

namespace usar::mission {

std::optional<FaultNote> readFaultNote(const std::string& sentence) {
    const auto colon = sentence.find(" s: ");
    const auto text = colon == std::string::npos ? colon : sentence.find(": ", colon + 4);
    const auto time_s = text == std::string::npos ? std::nullopt : readNumber(sentence.substr(0, colon));
    if (!time_s)
        return std::nullopt;
    const bool begins = sentence.substr(colon + 4, text - colon - 4) == "fault begins";
    return FaultNote{Seconds{*time_s}, begins, sentence.substr(text + 2)};
}

void StandingFaults::take(const std::string& sentence) {
    const auto note = readFaultNote(sentence);
    if (!note)
        return;
    if (note->begins) {
        sentences_.push_back(sentence);
        return;
    }
    const auto same = std::ranges::find_if(
        sentences_, [&](const std::string& begun) { return readFaultNote(begun)->fault == note->fault; });
    if (same != sentences_.end())
        sentences_.erase(same);
}

} // namespace usar::mission
