// The part of PlanDesk for commands, the context menu of a card, and the connections of the panel.
#include <algorithm>

#include <QMenu>

#include "app/desks/plan_desk.h"

namespace usar::app {

using posh::BreakOn;
using widgets::PlanNodeKind;

void PlanDesk::registerCommands() {
    registerPictureCommand();
    registerRunCommands();
    registerBreakpointCommands();
    registerPinCommands();
    registerTimeCommands();
}

bool PlanDesk::selectedIs(std::initializer_list<PlanNodeKind> kinds) const {
    const widgets::PlanView& view = views_.plan->view();
    if (view.selected() < 0)
        return false;
    const PlanNodeKind kind = view.tree()[view.selected()].kind;
    return kinds.size() == 0 || std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
}

void PlanDesk::registerRunCommands() {
    const auto flies = [this] { return robot() && robot()->running() && !watch().empty(); };
    const auto halted = [this, flies] { return flies() && robot()->view().halted; };
    commands_.add(
        {"plan.continue",
         tr("Go on"),
         tr("Plan"),
         tr("Until a breakpoint stops the plan"),
         "play",
         {QKeySequence("F5")}},
        [this](bool) { goOn(); }, halted);
    commands_.add(
        {"plan.halt",
         tr("Halt the plan"),
         tr("Plan"),
         tr("Behind its next cycle; the robot has its safe command, and our simulator's time stands still"),
         "pause",
         {QKeySequence("Shift+F5")}},
        [this](bool) { robot()->control(agent::PlanStep::Halt); },
        [this, flies] { return flies() && !robot()->view().halted; });
    commands_.add(
        {"plan.step_cycle",
         tr("One cycle"),
         tr("Plan"),
         tr("Until the plan has decided once more, then it stands still again"),
         "step",
         {QKeySequence("F11")}},
        [this](bool) {
            epoch_wanted_ = false;
            stepCycle();
        },
        halted);
    commands_.add(
        {"plan.step_epoch",
         tr("One epoch"),
         tr("Plan"),
         tr("The next look within this cycle: a new one follows each act that took no time; then the next cycle"),
         "down",
         {QKeySequence("Shift+F11")}},
        [this](bool) { stepEpoch(); }, halted);
    commands_.add(
        {"plan.run_to",
         tr("Run to here"),
         tr("Plan"),
         tr("Until the selected part of the plan is reached"),
         "follow",
         {QKeySequence("Ctrl+F6")}},
        [this](bool) { runToSelected(); }, [this, flies] { return flies() && selectedIs({}); });
}

void PlanDesk::registerBreakpointCommands() {
    const auto add = [this](const QString& id, const QString& text, const QString& help, BreakOn on,
                            std::initializer_list<PlanNodeKind> kinds, const QList<QKeySequence>& keys = {}) {
        const std::vector<PlanNodeKind> where(kinds);
        commands_.add(
            {id, text, tr("Plan"), help, "", keys}, [this, on](bool) { toggleBreakpoint(on); },
            [this, where] {
                return selectedIs({}) && watch().program() &&
                       (where.empty() || std::ranges::any_of(where, [this](auto kind) { return selectedIs({kind}); }));
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
        [this](bool) { toggleKeyBreakpoint(); },
        [this] { return watch().program() && !views_.plan->selectedKey().isEmpty(); });
    const auto any = [this] { return !breakpointsSelected().empty(); };
    commands_.add(
        {"plan.break_edit",
         tr("Change breakpoint…"),
         tr("Plan"),
         tr("Condition, count of hits, once; sets one where there is none"),
         "settings",
         {QKeySequence("Shift+F6")}},
        [this](bool) { editSelected(); }, [this] { return selectedIs({}) && watch().program(); });
    commands_.add(
        {"plan.break_switch", tr("Breakpoint on or off"), tr("Plan"), tr("It stays, and does not stop"), "", {}},
        [this](bool) { switchSelected(); }, any);
    commands_.add(
        {"plan.break_clear", tr("Remove all breakpoints"), tr("Plan"), tr("Of this plan"), "trash", {}},
        [this](bool) {
            for (const int id : list_.ofPlan(watch().program()->title))
                list_.remove(id);
            breakpointsChanged();
        },
        [this] { return watch().program() && !list_.ofPlan(watch().program()->title).empty(); });
}

void PlanDesk::registerPinCommands() {
    const auto flies = [this] { return robot() && robot()->running(); };
    commands_.add(
        {"plan.pin",
         tr("Pin its answer…"),
         tr("Plan"),
         tr("The sense or act answers what you say, in place of the robot; again: released"),
         "",
         {}},
        [this](bool) { pinSelected(); },
        [this, flies] {
            return flies() && selectedIs({PlanNodeKind::Sense, PlanNodeKind::Act});
        });
    commands_.add(
        {"plan.drive_off", tr("Drive off or on"), tr("Plan"), tr("A drive that is off is never ready"), "", {}},
        [this](bool) { toggleDrive(); }, [this, flies] { return flies() && selectedIs({PlanNodeKind::Drive}); });
    commands_.add(
        {"plan.release",
         tr("Release all that is pinned"),
         tr("Plan"),
         tr("Senses, acts and drives of this robot are its own again"),
         "reset",
         {}},
        [this](bool) {
            pins_.erase(control_.connectionOf(selected_));
            pinsChanged();
        },
        [this] {
            const auto pins = pins_.find(control_.connectionOf(selected_));
            return pins != pins_.end() && !pins->second.empty();
        });
}

void PlanDesk::wire() {
    widgets::PlanPanel& panel = *views_.plan;
    panel.haltBar().setActions(
        {commands_.action("plan.continue"), commands_.action("plan.step_cycle"), commands_.action("plan.step_epoch")});
    panel.timeBar().setActions(commands_.action("plan.halt"), commands_.action("plan.back"),
                               commands_.action("plan.forward"), commands_.action("plan.look_back"),
                               commands_.action("plan.live"));
    connect(&selection_, &Selection::changed, this, &PlanDesk::select);
    connect(&control_, &MissionControl::robotUpdated, this, [this](int id, const auto& update) { take(id, *update); });
    connect(&panel, &widgets::PlanPanel::exportRequested, this, &PlanDesk::chooseWhereToSavePicture);
    connect(&panel.timeBar(), &widgets::PlanTimeBar::timeWanted, this, &PlanDesk::goTo);
    connect(&panel.view(), &widgets::PlanView::selectionChanged, this, [this] { commands_.refresh(); });
    connect(&panel.view(), &widgets::PlanView::menuRequested, this, &PlanDesk::openMenu);
    connect(&panel, &widgets::PlanPanel::keySelected, this, [this] { commands_.refresh(); });
    connect(&panel, &widgets::PlanPanel::keyActivated, this, &PlanDesk::toggleKeyBreakpoint);
    connect(&panel, &widgets::PlanPanel::breakpointSwitched, this, &PlanDesk::switchBreakpoint);
    connect(&panel, &widgets::PlanPanel::breakpointEditRequested, this, &PlanDesk::editBreakpoint);
    connect(&panel, &widgets::PlanPanel::breakpointRemoved, this, [this](int id) {
        list_.remove(id);
        breakpointsChanged();
    });
    connect(&control_, &MissionControl::robotAdded, this, &PlanDesk::welcome);
    connect(&control_, &MissionControl::replayAdded, this, [this](int id) {
        if (const int flies = control_.lookedBackOn(id))
            watches_[control_.connectionOf(id)].expect(watches_[control_.connectionOf(flies)]);
    });
    connect(&control_, &MissionControl::robotRemoved, this, [this] {
        if (!anyHalted())
            emit timeWanted(true);
    });
    connect(&control_, &MissionControl::behaviorFinished, this, [this](int id) {
        stepping_ = false;
        if (!anyHalted())
            emit timeWanted(true);
        if (id != selected_)
            return;
        showHalt();
        showMarks();
    });
}

void PlanDesk::openMenu(int, const QPoint& at) {
    commands_.refresh();
    auto* const menu = new QMenu(window_);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    QStringList ids{"plan.break_before", "plan.break_after"};
    for (const char* const id : {"plan.break_result", "plan.break_verdict", "plan.break_interruption"})
        if (commands_.action(id)->isEnabled())
            ids << id;
    ids << "plan.break_edit"
        << "plan.break_switch"
        << "-"
        << "plan.run_to"
        << "-";
    for (const char* const id : {"plan.pin", "plan.drive_off"})
        if (commands_.action(id)->isEnabled())
            ids << id;
    ids << "plan.release";
    commands_.fill(menu, ids);
    menu->popup(at);
}

} // namespace usar::app
