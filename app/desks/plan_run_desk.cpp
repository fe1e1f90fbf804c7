#include "app/desks/plan_run_desk.h"

#include <algorithm>

#include <QFileDialog>
#include <QSaveFile>

#include "core/mission/reports/run_report_text.h"
#include "widgets/panels/report_dialog.h"

namespace usar::app {

using widgets::PlanSpot;

PlanRunDesk::PlanRunDesk(const DeskContext& context)
    : control_(context.control)
    , views_(context.views)
    , commands_(context.commands)
    , selection_(context.selection)
    , notices_(context.notices)
    , window_(context.window) {}

void PlanRunDesk::registerCommands() {
    const auto known = [this] { return watch().time().cycle > 0; };
    commands_.add(
        {"plan.back",
         tr("One cycle back"),
         tr("Plan"),
         tr("Shows what the plan did before; the robot flies on"),
         "back",
         {QKeySequence("Alt+PgUp")}},
        [this](bool) { stepBy(-1); }, known);
    commands_.add(
        {"plan.forward",
         tr("One cycle forward"),
         tr("Plan"),
         tr("Shows what the plan did next"),
         "forward",
         {QKeySequence("Alt+PgDown")}},
        [this](bool) { stepBy(1); }, known);
    commands_.add(
        {"plan.live",
         tr("Back to now"),
         tr("Plan"),
         tr("Shows what the robot and its plan do now, and goes on showing it; a replay from here is closed"),
         "record",
         {QKeySequence("Alt+End")}},
        [this](bool) { backToNow(); },
        [this] { return !watch().live() || control_.lookedBackOn(selection_.id()) != 0; });
    look_back_help_ = commands_
                          .add(
                              {"plan.look_back",
                               tr("Replay from here"),
                               tr("Plan"),
                               tr("Map, sensors, plots and plan as they were at this moment, from what is recorded; "
                                  "the robot flies on, and Back to now returns to it"),
                               "history",
                               {QKeySequence("Alt+Shift+End")}},
                              [this](bool) { lookBack(); }, [this] { return whyNoLookBack().isEmpty(); })
                          ->toolTip();
    commands_.add(
        {"plan.report",
         tr("Report on the run…"),
         tr("Plan"),
         tr("What never happened, what took turns without end, and where the time went, up to the shown moment"),
         "note",
         {}},
        [this](bool) { showReport(); }, known);
}

void PlanRunDesk::wire() {
    views_.plan->timeBar().setActions(commands_.action("plan.halt"), commands_.action("plan.back"),
                                      commands_.action("plan.forward"), commands_.action("plan.look_back"),
                                      commands_.action("plan.live"));
    connect(&views_.plan->timeBar(), &widgets::PlanTimeBar::timeWanted, this, &PlanRunDesk::goTo);
    connect(&control_, &MissionControl::replayAdded, this, [this](int id) {
        if (const int flies = control_.lookedBackOn(id))
            watches_[control_.connectionOf(id)].expect(watches_[control_.connectionOf(flies)]);
    });
}

PlanRunDesk::News PlanRunDesk::take(const Robot& robot, const mission::SessionUpdate& update) {
    return watches_[robot.view().connection].take(
        {update.published, update.figures.now, update.figures.replay.has_value(), update.rewound});
}

void PlanRunDesk::select() {
    views_.plan->clear();
    if (selection_.robot())
        show(News::Plan);
    showTime();
    showLookBack();
}

void PlanRunDesk::show(News news) {
    const widgets::PlanWatch& shown = watch();
    if (news == News::Plan) {
        if (shown.empty()) {
            views_.plan->clear();
        } else {
            views_.plan->setPlan(shown.plan());
            views_.plan->setPlanText(shown.planText(), shown.findings());
        }
        emit planShown(shown.planText());
    }
    if (news == News::None)
        return;
    if (!shown.empty())
        views_.plan->setSnapshot(shown.snapshot());
    showTime();
}

void PlanRunDesk::showTime() {
    const bool was_live = views_.plan->timeBar().time().live;
    views_.plan->timeBar().setTime(watch().time());
    if (was_live != watch().live())
        commands_.refresh();
}

void PlanRunDesk::showNewest(bool first_epoch) {
    const News news = first_epoch ? watch().goToFirstEpoch() : News::None;
    show(news == News::None ? watch().goLive() : news);
}

bool PlanRunDesk::stepEpoch() {
    const News news = watch().stepEpoch();
    show(news);
    return news != News::None;
}

std::vector<PlanSpot> PlanRunDesk::selectedSpots() {
    const widgets::PlanView& view = views_.plan->view();
    const auto& program = watch().program();
    return program ? widgets::spotsOfNode(*program, watch().paths(), view.tree(), view.selected())
                   : std::vector<PlanSpot>();
}

bool PlanRunDesk::selectedIs(std::initializer_list<widgets::PlanNodeKind> kinds) const {
    const widgets::PlanView& view = views_.plan->view();
    if (!view.selected().valid())
        return false;
    const widgets::PlanNodeKind kind = view.tree()[view.selected()].kind;
    return kinds.size() == 0 || std::ranges::find(kinds, kind) != kinds.end();
}

/// Moves a replay, with all views, to that moment. For a live robot only the plan's panel shows that moment; the robot
/// continues.
void PlanRunDesk::goTo(Seconds time) {
    if (Robot* const shown = selection_.robot(); shown && shown->isReplay()) {
        constexpr Seconds behind{0.02}; // so that the cycle itself is included
        return shown->orderReplay({.seek_clock = time + behind});
    }
    show(watch().goTo(time));
}

void PlanRunDesk::stepBy(int cycles) {
    if (const Robot* const shown = selection_.robot(); shown && shown->isReplay())
        return goTo(watch().timeOfStep(cycles));
    show(watch().step(cycles));
}

/// Opens the recording at the shown moment of the plan, or at the current moment if no plan is running.
void PlanRunDesk::lookBack() {
    constexpr Seconds behind{0.02};
    const widgets::PlanTime time = watch().time();
    views_.plan->timeBar().slider()->setFocus(); // the button gets disabled, and the next keys control a replay
    control_.lookBack(selection_.id(), time.cycle > 0 ? time.shown + behind : selection_.robot()->view().figures.now);
}

void PlanRunDesk::backToNow() {
    if (control_.lookedBackOn(selection_.id()) != 0)
        control_.remove(selection_.id()); // the live robot is selected instead
    show(watch().goLive());
}

QString PlanRunDesk::whyNoLookBack() const {
    const Robot* const shown = selection_.robot();
    if (!shown)
        return tr("No robot is selected");
    if (shown->isReplay())
        return tr("This is a replay: its slider moves map and sensors, too");
    if (!shown->view().figures.recording)
        return tr("Nothing is recorded of this robot; Ctrl+Alt+R begins");
    return {};
}

void PlanRunDesk::showLookBack() {
    const QString why = whyNoLookBack();
    QAction* const action = commands_.action("plan.look_back");
    if (why == no_look_back_ && action->isEnabled() == why.isEmpty())
        return;
    no_look_back_ = why;
    action->setToolTip(why.isEmpty() ? look_back_help_ : why);
    commands_.refresh();
}

/// Shows a report of the run up to the moment of the request; the robot continues meanwhile.
void PlanRunDesk::showReport() {
    const posh::RunStatistics statistics = watch().statistics();
    const QString plan = QString::fromStdString(statistics.program()->title);
    const std::string text = mission::runReportText(statistics, 1);
    auto* const dialog = new widgets::ReportDialog(tr("Run of %1").arg(plan), QString::fromStdString(text), window_);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &widgets::ReportDialog::saveRequested, this, [this, dialog, plan, statistics] {
        const QString path = QFileDialog::getSaveFileName(dialog, tr("Save report"), plan + ".txt",
                                                          tr("Text (*.txt);;JSON lines (*.jsonl)"));
        if (!path.isEmpty())
            saveReport(path, statistics);
    });
    dialog->show();
}

void PlanRunDesk::saveReport(const QString& path, const posh::RunStatistics& statistics) {
    const bool for_machines = path.endsWith(".jsonl") || path.endsWith(".json");
    const QByteArray bytes = for_machines ? mission::runReportJson(statistics, 1)
                                          : QByteArray::fromStdString(mission::runReportText(statistics, 1));
    QSaveFile file(path);
    if (file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size() && file.commit())
        notices_.note("plan-report", tr("Saved the report as %1.").arg(path));
    else
        notices_.say(Severity::Error, "plan-report",
                     tr("The report cannot be written: %1 (%2). Choose another place.").arg(file.errorString(), path));
}

} // namespace usar::app
