#include "app/desks/plan_desk.h"

#include <algorithm>
#include <utility>

#include <QMenu>

#include "core/mission/fleet/robot.h"
#include "widgets/models/plan/plan_marks.h"
#include "widgets/models/plan/plan_news.h"
#include "widgets/panels/dialogs.h"
#include "widgets/plan/breakpoint_dialog.h"
#include "widgets/plan/plan_picture.h"

namespace usar::app {

using widgets::PlanNodeKind;
using widgets::PlanSpot;

void PlanDesk::registerCommands() {
    const auto drawn = [this] { return !views_.plan->view().tree().empty(); };
    add("plan.save_picture", drawn, [this] { chooseWhereToSavePicture(); });
    registerRunCommands();
    breakpoints_.registerCommands();
    registerPinCommands();
    run_.registerCommands();
    commands_.offer([this] { return places(); });
}

void PlanDesk::chooseWhereToSavePicture() {
    widgets::askWhereToSave(window_, tr("Save plan as picture"), tr("plan.svg"), tr("Drawings (*.svg *.pdf *.png)"),
                            [this](const QString& path) {
                                if (const auto saved = widgets::savePlanPicture(views_.plan->view(), path); !saved)
                                    return notices_.complain("plan-picture", saved.error());
                                notices_.note("plan-picture", tr("Saved the plan as %1.").arg(path));
                            });
}

std::vector<widgets::PaletteOffer> PlanDesk::places() const {
    constexpr std::size_t most = 500; // A longer plan gives its first ones; its own search finds all.
    std::vector<widgets::PaletteOffer> offers;
    const widgets::PlanTree& tree = views_.plan->view().tree();
    for (const widgets::PlanNodeId node : tree.nodes()) {
        if (offers.size() == most)
            break;
        const QString kind = widgets::planKindWord(tree[node].kind);
        offers.push_back({tr("Go to %1 %2").arg(kind, tree[node].name),
                          tr("Plan"),
                          {"find", "show", "jump"},
                          [this, path = tree.path(node)] {
                              raise(views_.plan_dock);
                              views_.plan->view().selectPath(path);
                          }});
    }
    return offers;
}

void PlanDesk::registerRunCommands() {
    const auto flies = [this] { return robot() && robot()->running() && !run_.watch().empty(); };
    const auto halted = [this, flies] { return flies() && robot()->view().halted; };
    add("plan.continue", halted, [this] { goOn(); });
    const auto moves = [this, flies] { return flies() && !robot()->view().halted; };
    add("plan.halt", moves, [this] { robot()->control(agent::PlanStep::Halt); });
    add("plan.step_cycle", halted, [this] {
        epoch_wanted_ = false;
        stepCycle();
    });
    add("plan.step_epoch", halted, [this] { stepEpoch(); });
    const auto has_place = [this, flies] { return flies() && run_.selectedIs({}); };
    add("plan.run_to", has_place, [this] {
        breakpoints_.setTemporary();
        goOn();
    });
}

void PlanDesk::registerPinCommands() {
    const auto can = [this](std::vector<PlanNodeKind> kinds) {
        return [this, kinds] { return robot() && robot()->running() && run_.selectedIs(kinds); };
    };
    add("plan.pin", can({PlanNodeKind::Sense, PlanNodeKind::Act}), [this] { pinSelected(); });
    add("plan.drive_off", can({PlanNodeKind::Drive}), [this] { toggleDrive(); });
    const auto pinned = [this] {
        const auto pins = pins_.find(control_.connectionOf(selection_.id()));
        return pins != pins_.end() && !pins->second.empty();
    };
    add("plan.release", pinned, [this] {
        pins_.erase(control_.connectionOf(selection_.id()));
        pinsChanged();
    });
}

void PlanDesk::wire() {
    run_.wire();
    breakpoints_.wire();
    widgets::PlanPanel& panel = *views_.plan;
    panel.haltBar().setActions({action("plan.continue"), action("plan.step_cycle"), action("plan.step_epoch")});
    connect(&selection_, &Selection::changed, this, &PlanDesk::select);
    connect(&control_, &MissionControl::robotUpdated, this,
            [this](RobotId id, const auto& update) { take(id, *update); });
    connect(&run_, &PlanRunDesk::planShown, this, [this](const std::string& text) {
        breakpoints_.repairPaths();
        showMarks();
        emit planShown(text);
    });
    connect(&breakpoints_, &BreakpointDesk::changed, this, &PlanDesk::showMarks);
    connect(&panel, &widgets::PlanPanel::exportRequested, this, &PlanDesk::chooseWhereToSavePicture);
    connect(&panel.view(), &widgets::PlanView::selectionChanged, this, [this] { commands_.refresh(); });
    connect(&panel.view(), &widgets::PlanView::menuRequested, this, &PlanDesk::openMenu);
    connect(&panel, &widgets::PlanPanel::keySelected, this, [this] { commands_.refresh(); });
    connect(&control_, &MissionControl::robotRemoved, this, [this] {
        if (!anyHalted())
            emit timeWanted(true);
    });
    connect(&control_, &MissionControl::behaviorFinished, this, [this](RobotId id) {
        stepping_ = false;
        if (!anyHalted())
            emit timeWanted(true);
        if (id != selection_.id())
            return;
        showHalt();
        showMarks();
    });
}

void PlanDesk::openMenu(widgets::PlanNodeId, const QPoint& at) {
    commands_.refresh();
    auto* const menu = new QMenu(window_);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    QStringList ids = QString("plan.break_before plan.break_after plan.break_result plan.break_verdict "
                              "plan.break_interruption plan.break_edit plan.break_switch - plan.run_to - "
                              "plan.pin plan.drive_off plan.release")
                          .split(' ');
    for (const char* const id : {"plan.break_result", "plan.break_verdict", "plan.break_interruption", "plan.pin",
                                 "plan.drive_off"}) // They are for some kinds of parts only.
        if (!action(id)->isEnabled())
            ids.removeOne(id);
    commands_.fill(menu, ids);
    menu->popup(at);
}

void PlanDesk::begin(RobotId id) {
    pins_.erase(control_.connectionOf(id));
    if (id == selection_.id())
        showMarks();
}

void PlanDesk::take(RobotId id, const mission::SessionUpdate& update) {
    const Robot* const robot = control_.robot(id);
    if (!robot)
        return;
    const PlanRunDesk::News news = run_.take(*robot, update);
    if (!robot->isReplay())
        for (const agent::Published& published : update.published)
            std::visit([&](const auto& value) { takeNews(id, value); }, published);
    if (id != selection_.id())
        return;
    run_.show(news);
    run_.showLookBack();
}

void PlanDesk::select() {
    epoch_wanted_ = false;
    run_.select();
    showHalt();
    showMarks();
}

void PlanDesk::showHalt() {
    const Robot* const shown = robot();
    views_.plan->haltBar().setText(
        shown && shown->standsStill()
            ? widgets::haltText(nameOf(*shown), *shown->view().halted, shown->view().figures.lockstep)
            : QString());
}

void PlanDesk::showMarks() {
    const widgets::PlanWatch& shown = run_.watch();
    std::vector<widgets::PlanMark> marks;
    if (shown.program()) {
        widgets::markBreakpoints(breakpoints_.list(), shown.program()->title, marks);
        if (const auto pins = pins_.find(control_.connectionOf(selection_.id())); pins != pins_.end())
            widgets::markPins(pins->second.all(), *shown.program(), shown.paths(), marks);
        const Robot* const flown = robot();
        if (flown && flown->standsStill() && !flown->view().halted->path.empty())
            widgets::markHalt(flown->view().halted->path, marks);
    }
    views_.plan->view().setMarks(std::move(marks));
    breakpoints_.show();
    commands_.refresh();
}

void PlanDesk::takeNews(RobotId id, const agent::PlanHalted& halted) {
    const Robot& robot = *control_.robot(id);
    breakpoints_.takeHalt(halted.breakpoint);
    stepping_ = false;
    if (halted.breakpoint)
        views_.notifications->push("plan-halted/" + nameOf(robot), Severity::Note,
                                   tr("%1 stands still: %2.").arg(nameOf(robot), QString::fromStdString(halted.reason)),
                                   id != selection_.id());
    emit timeWanted(false);
    if (id != selection_.id())
        return;
    run_.showNewest(std::exchange(epoch_wanted_, false));
    showHalt();
    showMarks();
    if (!halted.path.empty())
        views_.plan->view().selectPath(halted.path);
}

void PlanDesk::takeNews(RobotId id, const agent::PlanResumed&) {
    notices_.cure("plan-halted/" + nameOf(*control_.robot(id)));
    if (!anyHalted() && !stepping_)
        emit timeWanted(true);
    if (id != selection_.id() || stepping_) // it will halt again in a moment
        return;
    showHalt();
    showMarks();
}

void PlanDesk::takeNews(RobotId id, const agent::PlanReplaced& replaced) {
    const auto [severity, text] = widgets::replacedText(nameOf(*control_.robot(id)), replaced);
    notices_.say(severity, "plan-replaced/" + nameOf(*control_.robot(id)), text, true);
}

/// Robots whose server's time waits for all of them (lockstep) continue together.
void PlanDesk::stepCycle() {
    stepping_ = true;
    for (Robot* each : control_.robots())
        if (each->standsStill() && (each == robot() || each->view().figures.lockstep))
            each->control(agent::PlanStep::Cycle);
    emit cycleWanted();
}

void PlanDesk::goOn() {
    epoch_wanted_ = stepping_ = false;
    mission::controlHalted(control_.robots(), agent::PlanStep::Continue);
}

void PlanDesk::stepEpoch() {
    if (run_.stepEpoch())
        return;
    stepCycle();
    epoch_wanted_ = true;
}

void PlanDesk::pinsChanged() {
    if (Robot* const pinned = robot())
        pinned->control(pins_[pinned->view().connection].all());
    showMarks();
}

void PlanDesk::pinSelected() {
    const std::vector<PlanSpot> spots = run_.selectedSpots();
    if (spots.empty() || spots.front().call.empty() || !robot())
        return;
    const std::string call = spots.front().call;
    const ConnectionId connection = robot()->view().connection;
    if (pins_[connection].release(spots.front()))
        return pinsChanged();
    const bool is_act = spots.front().kind == posh::PlaceKind::Act;
    const auto& answer = views_.plan->view().states()[views_.plan->view().selected()].answer;
    const QString shown = QString::fromStdString(call);
    auto* const dialog = new widgets::PinDialog(
        shown, is_act ? std::nullopt : std::optional(answer ? answer->value : QString()), window_);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog, is_act, call, connection] {
        if (is_act)
            pins_[connection].pinAct(call, dialog->result());
        else if (const auto value = dialog->answer())
            pins_[connection].pinSense(call, *value);
        pinsChanged();
    });
    dialog->show(); // Not modal: the robot goes on.
}

void PlanDesk::toggleDrive() {
    const std::vector<PlanSpot> spots = run_.selectedSpots();
    if (spots.empty() || !robot())
        return;
    pins_[robot()->view().connection].toggleDrive(spots.front());
    pinsChanged();
}

} // namespace usar::app
