#include "app/desks/breakpoint_desk.h"

#include <algorithm>
#include <utility>

#include "widgets/plan/breakpoint_dialog.h"

namespace usar::app {

using agent::BreakpointId;
using posh::BreakOn;
using widgets::PlanNodeKind;

BreakpointDesk::BreakpointDesk(const DeskContext& context, PlanRunDesk& run)
    : control_(context.control)
    , views_(context.views)
    , commands_(context.commands)
    , window_(context.window)
    , run_(run) {}

void BreakpointDesk::registerCommands() {
    const auto add = [this](const QString& id, const QString& text, const QString& help, BreakOn on,
                            std::initializer_list<PlanNodeKind> kinds, const QList<QKeySequence>& keys = {}) {
        const std::vector<PlanNodeKind> where(kinds);
        commands_.add(
            {id, text, tr("Plan"), help, "", keys}, [this, on](bool) { toggle(on); },
            [this, where] {
                return run_.selectedIs({}) && run_.watch().program() &&
                       (where.empty() ||
                        std::ranges::any_of(where, [this](auto kind) { return run_.selectedIs({kind}); }));
            });
    };
    add("plan.break_before", tr("Breakpoint before it"), tr("Stops when it is about to begin; again: no more"),
        BreakOn::Before, {}, {QKeySequence("F6")});
    add("plan.break_after", tr("Breakpoint after it"), tr("Stops when it is over; again: no more"), BreakOn::After, {});
    add("plan.break_result", tr("Breakpoint on its failure"),
        tr("Stops when the act answers that it failed; again: no more. Another answer can be chosen with Change"),
        BreakOn::Result, {PlanNodeKind::Act});
    add("plan.break_verdict", tr("Breakpoint on a change of its verdict"),
        tr("Stops when the sense holds that did not, or the reverse; again: no more"), BreakOn::VerdictChange,
        {PlanNodeKind::Sense});
    add("plan.break_interruption", tr("Breakpoint on its interruption"),
        tr("Stops when something more urgent displaces it; again: no more"), BreakOn::Interruption,
        {PlanNodeKind::Drive, PlanNodeKind::Act});
    commands_.add(
        {"plan.break_key",
         tr("Breakpoint on the selected key"),
         tr("Plan"),
         tr("Stops when an act writes another value under this key of the blackboard; again: no more"),
         "",
         {}},
        [this](bool) { toggleKey(); },
        [this] { return run_.watch().program() && !views_.plan->selectedKey().isEmpty(); });
    commands_.add(
        {"plan.break_edit",
         tr("Change breakpoint…"),
         tr("Plan"),
         tr("Condition, count of hits, once; sets one where there is none"),
         "settings",
         {QKeySequence("Shift+F6")}},
        [this](bool) { editSelected(); }, [this] { return run_.selectedIs({}) && run_.watch().program(); });
    commands_.add(
        {"plan.break_switch", tr("Breakpoint on or off"), tr("Plan"), tr("It stays, and does not stop"), "", {}},
        [this](bool) {
            list_.toggleEnabled(selected());
            passOn();
        },
        [this] { return !selected().empty(); });
    commands_.add(
        {"plan.break_clear", tr("Remove all breakpoints"), tr("Plan"), tr("Of this plan"), "trash", {}},
        [this](bool) { clear(); },
        [this] { return run_.watch().program() && !list_.ofPlan(run_.watch().program()->title).empty(); });
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

void BreakpointDesk::save(QSettings& settings) const {
    widgets::BreakpointList lasting = list_;
    lasting.remove(temporary_);
    settings.setValue("plan/breakpoints", lasting.toJson());
}

/// Sends the breakpoints to a newly spawned robot.
void BreakpointDesk::welcome(int id) {
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
    std::vector<widgets::BreakpointRow> rows;
    QStringList keys;
    if (run_.watch().program())
        for (const BreakpointId id : list_.ofPlan(planName())) {
            const posh::Breakpoint& breakpoint = *list_.find(id);
            QString help = QString::fromStdString(breakpoint.names);
            if (breakpoint.on == BreakOn::Written)
                keys << QString::fromStdString(breakpoint.key);
            if (breakpoint.path.empty())
                help += tr("\nThe plan has no such place now.");
            rows.push_back({id, widgets::breakpointText(breakpoint), help, breakpoint.path, breakpoint.enabled});
        }
    views_.plan->setBreakpoints(rows);
    views_.plan->setWatchedKeys(keys);
}

std::string BreakpointDesk::planName() {
    const auto& program = run_.watch().program();
    return program ? program->title : std::string();
}

std::vector<BreakpointId> BreakpointDesk::selected() {
    return list_.atSpots(planName(), run_.selectedSpots());
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

void BreakpointDesk::clear() {
    list_.remove(list_.ofPlan(planName()));
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
    dialog->open();
}

/// Edits the first breakpoint at the selected part; sets one if there is none.
void BreakpointDesk::editSelected() {
    if (selected().empty())
        toggle(BreakOn::Before);
    if (const std::vector<BreakpointId> ids = selected(); !ids.empty())
        edit(ids.front());
}

void BreakpointDesk::setTemporary() {
    dropTemporary();
    for (const widgets::PlanSpot& spot : run_.selectedSpots())
        temporary_.push_back(
            list_.add({.path = spot.path, .names = spot.names, .on = BreakOn::Before, .condition = {}, .once = true}));
    passOn();
}

void BreakpointDesk::dropTemporary() {
    if (temporary_.empty())
        return;
    list_.remove(std::exchange(temporary_, {}));
    passOn();
}

void BreakpointDesk::takeHalt(std::optional<BreakpointId> id) {
    if (const auto* const known = id ? list_.find(*id) : nullptr;
        known && known->once && !std::ranges::count(temporary_, *id))
        list_.enable(*id, false);
    dropTemporary();
}

} // namespace usar::app
