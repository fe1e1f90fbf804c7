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
    BreakpointDesk(const DeskContext& context, PlanRunDesk& run);

    void registerCommands() override;
    void wire() override;
    void restore(const QSettings& settings) override;
    void save(QSettings& settings) const override;

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
    void welcome(RobotId id);
    void passOn();
    void toggle(posh::BreakOn on);
    void toggleKey();
    void edit(agent::BreakpointId id);
    void editSelected();
    void clear();
    void dropTemporary();
    /// Ids of the breakpoints at the selected part.
    std::vector<agent::BreakpointId> selected();
    /// Name of the plan that is shown; empty if there is none.
    std::string planName();

    PlanRunDesk& run_;
    widgets::BreakpointList list_;
    std::vector<agent::BreakpointId> temporary_; ///< those of "run to here"
};

} // namespace usar::app
