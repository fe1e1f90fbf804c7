#include "app/desks/plan_run_desk.h"

#include <algorithm>

#include "core/mission/fleet/robot_words.h"
#include "core/mission/reports/run_report_text.h"
#include "widgets/panels/dialogs.h"

namespace usar::app {

using widgets::PlanSpot;

void PlanRunDesk::registerCommands() {
    const auto known = [this] { return watch().time().cycle > 0; };
    add("plan.back", known, [this] { stepBy(-1); });
    add("plan.forward", known, [this] { stepBy(1); });
    const auto not_now = [this] { return !watch().live() || control_.lookedBackOn(selection_.id()).valid(); };
    add("plan.live", not_now, [this] { backToNow(); });
    add(
        "plan.look_back", [this] { return whyNoLookBack().isEmpty(); }, [this] { lookBack(); });
    add("plan.report", known, [this] { showReport(); });
}

void PlanRunDesk::wire() {
    views_.plan->timeBar().setActions(action("plan.halt"), action("plan.back"), action("plan.forward"),
                                      action("plan.look_back"), action("plan.live"));
    connect(&views_.plan->timeBar(), &widgets::PlanTimeBar::timeWanted, this, &PlanRunDesk::goTo);
    connect(&control_, &MissionControl::replayAdded, this, [this](RobotId id) {
        if (const RobotId flies = control_.lookedBackOn(id); flies.valid())
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

bool PlanRunDesk::selectedIs(const std::vector<widgets::PlanNodeKind>& kinds) const {
    const widgets::PlanView& view = views_.plan->view();
    if (!view.selected().valid())
        return false;
    return kinds.empty() || std::ranges::count(kinds, view.tree()[view.selected()].kind) > 0;
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
    if (control_.lookedBackOn(selection_.id()).valid())
        control_.remove(selection_.id()); // the live robot is selected instead
    show(watch().goLive());
}

QString PlanRunDesk::whyNoLookBack() const {
    return mission::whyNoLookBack(robot() ? &robot()->view() : nullptr);
}

void PlanRunDesk::showLookBack() {
    const QString why = whyNoLookBack();
    QAction* const look_back = action("plan.look_back");
    if (why == no_look_back_ && look_back->isEnabled() == why.isEmpty())
        return;
    no_look_back_ = why;
    look_back->setToolTip(why.isEmpty() ? widgets::tooltipText(widgets::commandSpec("plan.look_back")) : why);
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
        const auto save = [this, statistics](const QString& path) {
            if (const auto saved = mission::saveRunReport(statistics, path); !saved)
                return notices_.complain("plan-report", saved.error());
            notices_.note("plan-report", tr("Saved the report as %1.").arg(path));
        };
        widgets::askWhereToSave(dialog, tr("Save report"), plan + ".txt", tr("Text (*.txt);;JSON lines (*.jsonl)"),
                                save);
    });
    dialog->show();
}

} // namespace usar::app
