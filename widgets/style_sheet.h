// The small application style sheet: what Fusion and a palette cannot say.
#pragma once

#include <QString>

#include "widgets/theme.h"

namespace usar::widgets {

/// Rules for tool tips, dock titles, headers, tabs, and the roles that labels, buttons and frames take by the dynamic
/// property `role`: labels "muted", "title", "danger", "caution", "ok"; buttons "primary", "stop"; frames "card",
/// "strip".
QString styleSheet(const Tokens& tokens);

} // namespace usar::widgets
