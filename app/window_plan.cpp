// The plan's part of MainWindow: its commands and wires.
#include <cmath>

#include <QFileDialog>
#include <QFileInfo>

#include "app/main_window.h"
#include "widgets/plan_picture.h"

namespace usar::app {

void MainWindow::registerPlanCommands() {
    workshop_.registerCommands();
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
    workshop_.wire();
    connect(&workshop_, &PlanWorkshop::planChosen, this, &MainWindow::keepDraft);
    connect(views_.plan, &widgets::PlanPanel::exportRequested, this, &MainWindow::chooseWhereToSavePlan);
    plan_.wire();
    connect(&plan_, &PlanDesk::planShown, &workshop_, &PlanWorkshop::setRunningPlan);
    connect(&plan_, &PlanDesk::timeWanted, this, [this](bool runs) { holdTime(!runs); });
    connect(&plan_, &PlanDesk::cycleWanted, this, [this] {
        if (!views_.time->paused())
            return;
        const double speed = views_.time->speed(); // the bar goes on saying that time stands still
        control_.setPace(std::isinf(speed) ? link::Pace::Fast : link::Pace::Factor, speed);
    });
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
