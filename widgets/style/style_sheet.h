// The small style sheet of the application: what the Fusion style and a palette cannot express.
#pragma once

#include <QString>

#include "widgets/style/theme.h"

namespace usar::widgets {

/// Rules for tooltips, dock titles, headers, tabs, and for the roles that widgets have by the dynamic property `role`:
/// labels "muted", "title", "danger", "caution", "ok"; buttons "primary", "stop"; frames "card", "strip".
QString styleSheet(const Tokens& tokens);

} // namespace usar::widgets
