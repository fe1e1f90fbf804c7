#include "app/desks/breakpoint_desk.h"

#include "widgets/plan/breakpoint_dialog.h"

namespace usar::app {

using agent::BreakpointId;
using posh::BreakOn;
using widgets::PlanNodeKind;

void BreakpointDesk::registerCommands() {
    const auto any = [this] { return run_.selectedIs({}) && run_.watch().program(); };
    const auto addKind = [this, any](const char* id, BreakOn on, const std::vector<PlanNodeKind>& kinds) {
        const auto fits = [this, any, kinds] { return any() && run_.selectedIs(kinds); };
        add(id, fits, [this, on] { toggle(on); });
    };
    addKind("plan.break_before", BreakOn::Before, {});
    addKind("plan.break_after", BreakOn::After, {});
    addKind("plan.break_result", BreakOn::Result, {PlanNodeKind::Act});
    addKind("plan.break_verdict", BreakOn::VerdictChange, {PlanNodeKind::Sense});
    addKind("plan.break_interruption", BreakOn::Interruption, {PlanNodeKind::Drive, PlanNodeKind::Act});
    const auto has_key = [this] { return run_.watch().program() && !views_.plan->selectedKey().isEmpty(); };
    add("plan.break_key", has_key, [this] { toggleKey(); });
    add("plan.break_edit", any, [this] { editSelected(); });
    const auto has_some = [this] { return !selected().empty(); };
    add("plan.break_switch", has_some, [this] {
        list_.toggleEnabled(selected());
        passOn();
    });
    const auto plan_has_some = [this] { return run_.watch().program() && !list_.ofPlan(planName()).empty(); };
    add("plan.break_clear", plan_has_some, [this] {
        list_.remove(list_.ofPlan(planName()));
        passOn();
    });
}

void BreakpointDesk::wire() {
    widgets::PlanPanel& panel = *views_.plan;
    connect(&panel, &widgets::PlanPanel::keyActivated, this, &BreakpointDesk::toggleKey);
    connect(&panel, &widgets::PlanPanel::breakpointSwitched, this, [this](BreakpointId id, bool on) {
        if (!list_.find(id))
            return;
        list_.enable(id, on);
        passOn();
    });
    connect(&panel, &widgets::PlanPanel::breakpointEditRequested, this, &BreakpointDesk::edit);
    connect(&panel, &widgets::PlanPanel::breakpointRemoved, this, [this](BreakpointId id) {
        list_.remove(id);
        passOn();
    });
    connect(&control_, &MissionControl::robotAdded, this, &BreakpointDesk::welcome);
}

void BreakpointDesk::restore(const QSettings& settings) {
    list_ = widgets::BreakpointList::fromJson(settings.value("plan/breakpoints").toByteArray());
    passOn();
}

void BreakpointDesk::save(SettingsSheet& settings) const {
    settings.setValue("plan/breakpoints", list_.toJson());
}

/// Sends the breakpoints to a newly spawned robot.
void BreakpointDesk::welcome(RobotId id) {
    if (Robot* robot = control_.robot(id); robot && !robot->isReplay())
        robot->control(agent::SetBreakpoints{list_.all()});
}

void BreakpointDesk::passOn() {
    for (Robot* robot : control_.robots())
        if (!robot->isReplay())
            robot->control(agent::SetBreakpoints{list_.all()});
    emit changed();
}

void BreakpointDesk::repairPaths() {
    if (const auto& program = run_.watch().program())
        list_.repairPaths(*program);
}

void BreakpointDesk::show() {
    views_.plan->setBreakpoints(list_.rowsOfPlan(planName()));
    views_.plan->setWatchedKeys(list_.keysOfPlan(planName()));
}

std::string BreakpointDesk::planName() {
    const auto& program = run_.watch().program();
    return program ? program->title : std::string();
}

void BreakpointDesk::toggle(BreakOn on) {
    list_.toggle(planName(), run_.selectedSpots(), on);
    passOn();
}

void BreakpointDesk::toggleKey() {
    const std::string key = views_.plan->selectedKey().toStdString();
    const auto& program = run_.watch().program();
    if (key.empty() || !program)
        return;
    list_.toggleKey(*program, key);
    passOn();
}

void BreakpointDesk::edit(BreakpointId id) {
    const posh::Breakpoint* const known = list_.find(id);
    if (!known)
        return;
    auto* const dialog = new widgets::BreakpointDialog(*known, window_);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, id, dialog] {
        list_.change(id, dialog->breakpoint());
        passOn();
    });
    dialog->show(); // Not modal: the robot goes on.
}

/// Edits the first breakpoint at the selected part; sets one if there is none.
void BreakpointDesk::editSelected() {
    if (selected().empty())
        toggle(BreakOn::Before);
    if (const std::vector<BreakpointId> ids = selected(); !ids.empty())
        edit(ids.front());
}

void BreakpointDesk::setTemporary() {
    list_.setTemporary(run_.selectedSpots());
    passOn();
}

void BreakpointDesk::takeHalt(std::optional<BreakpointId> id) {
    if (id)
        list_.takeHit(*id);
    if (list_.dropTemporary())
        passOn();
}

} // namespace usar::app
