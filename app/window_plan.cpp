// The plan's part of MainWindow: its commands and wires.
#include <cmath>

#include <QFileDialog>
#include <QFileInfo>

#include "app/main_window.h"
#include "core/mission/mission_check.h"
#include "widgets/plan_picture.h"

namespace usar::app {

void MainWindow::registerPlanCommands() {
    commands_.add({"plan.open",
                   tr("Open plan…"),
                   tr("Plan"),
                   tr("Let a POSH plan of your own decide for the robot (.lap)"),
                   "open",
                   {QKeySequence("Ctrl+Shift+O")}},
                  [this](bool) { choosePlanFile(); });
    commands_.add(
        {"plan.save_picture",
         tr("Save plan as picture…"),
         tr("Plan"),
         tr("The whole drawing, as SVG, PDF or PNG"),
         "",
         {}},
        [this](bool) { chooseWhereToSavePlan(); }, [this] { return !views_.plan->view().tree().empty(); });
    plan_.registerCommands();
}

void MainWindow::wirePlan() {
    connect(&views_.behavior->plan(), &widgets::PlanChoice::openRequested, this, &MainWindow::choosePlanFile);
    connect(views_.plan, &widgets::PlanPanel::exportRequested, this, &MainWindow::chooseWhereToSavePlan);
    plan_.wire();
    connect(&plan_, &PlanDesk::timeWanted, this, [this](bool runs) { holdTime(!runs); });
    connect(&plan_, &PlanDesk::cycleWanted, this, [this] {
        if (!views_.time->paused())
            return;
        const double speed = views_.time->speed(); // the bar goes on saying that time stands still
        control_.setPace(std::isinf(speed) ? link::Pace::Fast : link::Pace::Factor, speed);
    });
}

void MainWindow::choosePlanFile() {
    const QString path = QFileDialog::getOpenFileName(this, tr("Open plan"), {}, tr("POSH plans (*.lap *.posh)"));
    if (!path.isEmpty())
        openPlan(path);
}

/// A behavior that a plan decides: the chosen one, or else the first of the chosen one's robot.
std::string MainWindow::plannedBehavior() const {
    const auto& plugins = control_.plugins();
    const std::string chosen = views_.behavior->behaviorId();
    if (const auto* behavior = plugins.behavior(chosen); behavior && !behavior->plan_name.empty())
        return chosen;
    if (const auto* robot = plugins.robotOf(chosen))
        for (const agent::BehaviorDescription& behavior : robot->behaviors)
            if (!behavior.plan_name.empty())
                return behavior.id;
    return chosen;
}

void MainWindow::openPlan(const QString& path) {
    const std::string behavior_id = plannedBehavior();
    if (const auto plan = mission::readOwnPlan(path, behavior_id, control_.plugins()); !plan)
        return complain("plan", plan.error());
    views_.behavior->chooseBehavior(behavior_id);
    views_.behavior->plan().choose(path);
    keepDraft();
    control_.cure("plan");
    say(Severity::Note, "plan-ready", tr("%1 decides from the next start on.").arg(QFileInfo(path).fileName()));
}

void MainWindow::chooseWhereToSavePlan() {
    const QString path = QFileDialog::getSaveFileName(this, tr("Save plan as picture"), tr("plan.svg"),
                                                      tr("Drawings (*.svg *.pdf *.png)"));
    if (path.isEmpty())
        return;
    const QString file = QFileInfo(path).suffix().isEmpty() ? path + ".svg" : path;
    if (const auto saved = widgets::savePlanPicture(views_.plan->view(), file); !saved)
        return complain("plan-picture", saved.error());
    views_.notifications->push("plan-picture", Severity::Note, tr("Saved the plan as %1.").arg(file), true);
}

} // namespace usar::app
