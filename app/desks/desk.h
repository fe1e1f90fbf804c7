// The objects that every desk of the window works with.
#pragma once

#include "app/desks/notice_desk.h"
#include "app/desks/selection.h"
#include "app/host/mission_control.h"
#include "app/views/window_views.h"
#include "widgets/commands/command_registry.h"

namespace usar::app {

/// A desk handles one concern of the window: it registers its commands (`registerCommands`), connects its views to
/// MissionControl (`wire`), follows the selection, and saves and restores its settings. The window owns all of these
/// objects and every desk; they outlive the desks.
struct DeskContext {
    MissionControl& control;
    WindowViews& views;
    widgets::CommandRegistry& commands;
    Selection& selection;
    NoticeDesk& notices;
    QWidget* window; ///< parent of dialogs
};

} // namespace usar::app
