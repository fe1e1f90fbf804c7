// One value of a mission, replaced as `usar-mission run --set KEY=VALUE` asks for it.
#pragma once

#include <QString>

#include "core/base/result.h"
#include "core/mission/files/mission_file.h"

namespace usar::mission {

/// Replaces the value of one key; `text` is KEY=VALUE, with the key as a path in the mission file: "area.width=40",
/// "start=Hill", "preset=fast", "adjust=true", "parameters.scan_altitude_m=3". Texts may stand without quotes. Errors
/// that are found later about this value do not name the file. Fails on a key that no mission has, or that has an
/// option of its own (faults, behavior, plan), and on a value of another kind.
Result<void> setValue(Mission& mission, const QString& text);

} // namespace usar::mission
