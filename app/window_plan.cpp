// The plan's part of MainWindow: its commands and wires.
#include <QFileDialog>

#include "app/main_window.h"
#include "widgets/plan_picture.h"

namespace usar::app {

void MainWindow::registerPlanCommands() {
    commands_.add(
        {"plan.save_picture",
         tr("Save plan as picture…"),
         tr("Plan"),
         tr("The whole drawing, as SVG, PDF or PNG"),
         "",
         {}},
        [this](bool) { chooseWhereToSavePlan(); }, [this] { return !views_.plan->view().tree().empty(); });
}

void MainWindow::wirePlan() {
    connect(views_.plan, &widgets::PlanPanel::exportRequested, this, &MainWindow::chooseWhereToSavePlan);
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
