// A mission as a recording notes it when its behavior starts, so that a run that was cut off can be continued.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <QString>

#include "core/mission/files/mission_file.h"

namespace usar::mission {

/// What a run was to fly. The parameters of `mission` are as a file has them: angles are in degrees.
struct FlownMission {
    Mission mission;                     ///< its area is the whole one, also in a run that continues another
    std::optional<std::uint64_t> seed{}; ///< of the embedded simulator; absent: unknown
    QString continues{};                 ///< full path of the recording that the run continues; empty: none
};

/// Text of the note "mission" of a recording (resources/docs/recording-format.md). `specs`: the behavior's parameters,
/// if those of the mission are in the behavior's units; empty if they are as in a file.
std::string noteOf(const FlownMission& flown, const std::vector<agent::ParameterSpec>& specs = {});

/// Reads such a text. The error names `recording`, the file in which it stands.
Result<FlownMission> readFlownMission(std::string_view text, const QString& recording);

} // namespace usar::mission
