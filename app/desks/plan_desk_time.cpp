// The part of PlanDesk for the moments of a run: going to them, replaying from them, and the report; also the picture.
#include <QFileDialog>
#include <QFileInfo>
#include <QSaveFile>

#include "app/desks/plan_desk.h"
#include "core/mission/reports/run_report_text.h"
#include "widgets/panels/report_dialog.h"
#include "widgets/plan/plan_picture.h"

namespace usar::app {

void PlanDesk::registerPictureCommand() {
    commands_.add(
        {"plan.save_picture",
         tr("Save plan as picture…"),
         tr("Plan"),
         tr("The whole drawing, as SVG, PDF or PNG"),
         "",
         {}},
        [this](bool) { chooseWhereToSavePicture(); }, [this] { return !views_.plan->view().tree().empty(); });
}

void PlanDesk::chooseWhereToSavePicture() {
    const QString path = QFileDialog::getSaveFileName(window_, tr("Save plan as picture"), tr("plan.svg"),
                                                      tr("Drawings (*.svg *.pdf *.png)"));
    if (path.isEmpty())
        return;
    const QString file = QFileInfo(path).suffix().isEmpty() ? path + ".svg" : path;
    if (const auto saved = widgets::savePlanPicture(views_.plan->view(), file); !saved)
        return notices_.complain("plan-picture", saved.error());
    notices_.note("plan-picture", tr("Saved the plan as %1.").arg(file));
}

void PlanDesk::registerTimeCommands() {
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
        [this](bool) { backToNow(); }, [this] { return !watch().live() || control_.lookedBackOn(selected_) != 0; });
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

/// For a replay, all views go to that moment. For a live robot, only the plan is shown as it was; the robot continues.
void PlanDesk::goTo(Seconds time) {
    if (Robot* const shown = robot(); shown && shown->isReplay()) {
        constexpr Seconds behind{0.02}; // So that the cycle at that time has been played.
        return shown->orderReplay({.seek_clock = time + behind});
    }
    show(watch().goTo(time));
}

void PlanDesk::stepBy(int cycles) {
    if (const Robot* const shown = robot(); shown && shown->isReplay())
        return goTo(watch().timeOfStep(cycles));
    show(watch().step(cycles));
}

/// Replays the selected robot from the shown moment of its plan, or from now if there is none.
void PlanDesk::lookBack() {
    constexpr Seconds behind{0.02};
    const widgets::PlanTime time = watch().time();
    views_.plan->timeBar().slider()->setFocus(); // The button is disabled now, and the next keys are for the replay.
    control_.lookBack(selected_, time.cycle > 0 ? time.shown + behind : robot()->view().figures.now);
}

void PlanDesk::backToNow() {
    if (control_.lookedBackOn(selected_) != 0)
        control_.remove(selected_); // Selects its live robot.
    show(watch().goLive());
}

QString PlanDesk::whyNoLookBack() const {
    const Robot* const shown = robot();
    if (!shown)
        return tr("No robot is selected");
    if (shown->isReplay())
        return tr("This is a replay: its slider moves map and sensors, too");
    if (!shown->view().figures.recording)
        return tr("Nothing is recorded of this robot; Ctrl+Alt+R begins");
    return {};
}

/// Updates the command, whose tooltip says why it is disabled.
void PlanDesk::showLookBack() {
    const QString why = whyNoLookBack();
    QAction* const action = commands_.action("plan.look_back");
    if (why == no_look_back_ && action->isEnabled() == why.isEmpty())
        return;
    no_look_back_ = why;
    action->setToolTip(why.isEmpty() ? look_back_help_ : why);
    commands_.refresh();
}

/// Reports on the run up to the time of the call; the robot continues meanwhile.
void PlanDesk::showReport() {
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

void PlanDesk::saveReport(const QString& path, const posh::RunStatistics& statistics) {
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
