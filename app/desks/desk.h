// The base of the window's desks, and the objects that every desk works with.
#pragma once

#include <QSettings>

#include "app/desks/notice_desk.h"
#include "app/desks/selection.h"
#include "core/mission/files/settings_sheet.h"
#include "core/mission/fleet/robot.h"
#include "widgets/commands/command_registry.h"

namespace usar::app {

using mission::SettingsSheet;

/// The window owns all of these objects and every desk; they outlive the desks.
struct DeskContext {
    MissionControl& control;
    /// None of its pointers is null, because the views are made before any desk.
    widgets::WindowViews& views;
    widgets::CommandRegistry& commands;
    Selection& selection;
    NoticeDesk& notices;
    QWidget* window; ///< parent of dialogs
};

/// A desk handles one concern of the window. The window first calls `registerCommands` of every desk, then `wire` of
/// every desk, then `restore`. GUI thread.
class Desk : public QObject {
public:
    explicit Desk(const DeskContext& context)
        : control_(context.control)
        , views_(context.views)
        , commands_(context.commands)
        , selection_(context.selection)
        , notices_(context.notices)
        , window_(context.window) {}

    /// Adds the desk's commands to the registry, which may not have those of other desks yet.
    virtual void registerCommands() {}
    /// Connects the desk's views to MissionControl.
    virtual void wire() {}
    /// Reads the settings that `save` wrote when the program ran last.
    virtual void restore(const QSettings&) {}
    /// Writes the settings that `restore` reads; called once a second.
    virtual void save(SettingsSheet&) const {}

protected:
    /// The selected robot; nullptr while there is none.
    Robot* robot() const { return selection_.robot(); }
    /// True if the selected robot is spawned and connected, and no replay.
    bool live() const {
        return robot() && !robot()->isReplay() && robot()->view().figures.spawned &&
               robot()->view().link.state == link::LinkState::Connected;
    }
    /// Registers a command. `run` may take the checked state; `enabled` is evaluated again with each refresh of the
    /// registry.
    template <class Run>
    QAction* add(const widgets::CommandSpec& spec, std::function<bool()> enabled, Run run) {
        const auto call = [run](bool on) {
            if constexpr (std::is_invocable_v<Run, bool>)
                run(on);
            else
                run();
        };
        return commands_.add(spec, call, std::move(enabled));
    }
    /// The same for a command of the table, by its id.
    template <class Run>
    QAction* add(const char* id, std::function<bool()> enabled, Run run) {
        return add(widgets::commandSpec(id), std::move(enabled), std::move(run));
    }
    /// The same for a command that is always enabled.
    template <class Run>
    QAction* add(const char* id, Run run) {
        return add(id, nullptr, std::move(run));
    }
    /// The action of a registered command, of this desk or another one.
    QAction* action(const QString& id) const { return commands_.action(id); }
    /// Shows a dock and brings it in front of those that share its place.
    static void raise(QDockWidget* dock) {
        dock->show();
        dock->raise();
    }
    /// Calls `take` with each update of the selected robot.
    template <class Take>
    void connectUpdates(Take take) {
        connect(&control_, &MissionControl::robotUpdated, this, [this, take](RobotId id, const auto& update) {
            if (id == selection_.id())
                take(*update);
        });
    }

    MissionControl& control_;
    widgets::WindowViews& views_;
    widgets::CommandRegistry& commands_;
    Selection& selection_;
    NoticeDesk& notices_;
    QWidget* window_;
};

} // namespace usar::app
