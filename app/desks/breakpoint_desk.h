// The breakpoints that a user sets in robots' plans: their commands, and their list in the plan's panel.
#pragma once

#include <optional>
#include <vector>

#include "app/desks/desk.h"
#include "app/desks/plan_run_desk.h"
#include "widgets/models/plan/breakpoint_list.h"

namespace usar::app {

/// Breakpoints belong to plans, by the plans' names, and to all robots that run them. They are kept between runs of the
/// program. GUI thread.
class BreakpointDesk : public Desk {
    Q_OBJECT
public:
    BreakpointDesk(const DeskContext& context, PlanRunDesk& run) : Desk(context), run_(run) {}

    void registerCommands() override;
    void wire() override;
    void restore(const QSettings& settings) override;
    /// Leaves out temporary breakpoints.
    void save(SettingsSheet& settings) const override;

    /// All breakpoints of all plans, including temporary ones.
    const widgets::BreakpointList& list() const { return list_; }
    /// Finds the places of the breakpoints again in the plan that is shown now.
    void repairPaths();
    /// Lists the breakpoints of the plan that is shown.
    void show();
    /// Sets a breakpoint before the selected part that lasts until a plan halts.
    void setTemporary();
    /// A plan has halted, at the breakpoint with this id if one is given.
    void takeHalt(std::optional<agent::BreakpointId> id);

signals:
    /// The list has changed and was sent to the robots.
    void changed();

private:
    /// Sends the breakpoints to a newly spawned robot; replays get none.
    void welcome(RobotId id);
    /// Sends the list to all live robots and emits `changed`.
    void passOn();
    /// Sets a breakpoint of this kind at the selected part, or removes it.
    void toggle(posh::BreakOn on);
    /// The same for writes to the selected key of the blackboard; has no effect without one.
    void toggleKey();
    /// Opens a dialog that does not block; an unknown id has no effect.
    void edit(agent::BreakpointId id);
    /// Edits the first breakpoint at the selected part; sets one if there is none.
    void editSelected();
    /// Ids of the breakpoints at the selected part.
    std::vector<agent::BreakpointId> selected() { return list_.atSpots(planName(), run_.selectedSpots()); }
    /// Name of the plan that is shown; empty if there is none.
    std::string planName();

    PlanRunDesk& run_;
    widgets::BreakpointList list_;
};

} // namespace usar::app
