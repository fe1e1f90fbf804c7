// What is told of a task before it starts, as text.
#pragma once

#include <QString>

#include "core/agent/robot_plugin.h"

namespace usar::widgets {

/// "12 lanes in 4 parts · 2400 m · about 42 min".
QString previewText(const agent::TaskPreview& preview);
/// "In the open: 38 min to 47 min, 5 to 6 sorties, 93 to 99 % of the area shown".
QString outlookText(const agent::TaskOutlook& outlook);

} // namespace usar::widgets
