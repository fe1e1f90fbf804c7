// The gallery's pages: each makes one widget, filled with plausible data.
#pragma once

#include <memory>

#include <QWidget>

namespace usar::gallery {

std::unique_ptr<QWidget> mapPage();
std::unique_ptr<QWidget> robotsPage();
std::unique_ptr<QWidget> emptyRobotsPage();
std::unique_ptr<QWidget> notificationsPage();
std::unique_ptr<QWidget> toastsPage();
std::unique_ptr<QWidget> messagesPage();
std::unique_ptr<QWidget> areaPage();
std::unique_ptr<QWidget> emptyMapPage();
std::unique_ptr<QWidget> parametersPage();
std::unique_ptr<QWidget> plotPage();
std::unique_ptr<QWidget> emptyPlotPage();
std::unique_ptr<QWidget> iconsPage();
std::unique_ptr<QWidget> barsPage();
std::unique_ptr<QWidget> palettePage();
std::unique_ptr<QWidget> sheetPage();
std::unique_ptr<QWidget> instrumentsPage();
std::unique_ptr<QWidget> robotInstrumentsPage();
std::unique_ptr<QWidget> sensorsPage();
std::unique_ptr<QWidget> emptySensorsPage();
std::unique_ptr<QWidget> behaviorsPage();
std::unique_ptr<QWidget> stalePage();
std::unique_ptr<QWidget> spawnedPage();
std::unique_ptr<QWidget> planPage();
std::unique_ptr<QWidget> narrowPlanPage();
std::unique_ptr<QWidget> dockedPlanPage();
std::unique_ptr<QWidget> wholePlanPage();
std::unique_ptr<QWidget> planTextPage();
std::unique_ptr<QWidget> emptyPlanPage();
std::unique_ptr<QWidget> planEditorPage();
std::unique_ptr<QWidget> narrowPlanEditorPage();
std::unique_ptr<QWidget> faultyPlanEditorPage();

} // namespace usar::gallery
