// Sentences of the simulator about faults, as a recording has them: "60.2 s: fault begins: wind speed=5 from=60".
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/clock.h"

namespace usar::mission {

/// Holds what such a sentence says, as a plain value.
struct FaultNote {
    Seconds time{0.0}; ///< It is the simulation's.
    bool begins = true;
    std::string fault; ///< in the syntax of --fault
};

/// Nullopt for any other sentence.
std::optional<FaultNote> readFaultNote(const std::string& sentence);

/// The sentences of those faults that have begun and not ended. A plain value.
class StandingFaults {
public:
    void take(const std::string& sentence);
    const std::vector<std::string>& sentences() const { return sentences_; }

private:
    std::vector<std::string> sentences_;
};

} // namespace usar::mission
