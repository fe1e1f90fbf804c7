// widget_gallery [FOLDER] [NAME]: grabs every page (or one) in both themes as FOLDER/NAME-dark.png and -light.png.
#include <cstdio>
#include <vector>

#include <QApplication>
#include <QDir>
#include <QEventLoop>
#include <QThreadPool>
#include <QTimer>

#include "tests/widgets/gallery/pages.h"
#include "widgets/style/theme.h"

using namespace usar;

namespace {

struct Page {
    QString name;
    std::unique_ptr<QWidget> (*make)();
};

const std::vector<Page> pages = {
    {QStringLiteral("map"), gallery::mapPage},
    {QStringLiteral("robots"), gallery::robotsPage},
    {QStringLiteral("empty_robots"), gallery::emptyRobotsPage},
    {QStringLiteral("notifications"), gallery::notificationsPage},
    {QStringLiteral("toasts"), gallery::toastsPage},
    {QStringLiteral("messages"), gallery::messagesPage},
    {QStringLiteral("area"), gallery::areaPage},
    {QStringLiteral("empty_map"), gallery::emptyMapPage},
    {QStringLiteral("parameters"), gallery::parametersPage},
    {QStringLiteral("plot"), gallery::plotPage},
    {QStringLiteral("empty_plot"), gallery::emptyPlotPage},
    {QStringLiteral("icons"), gallery::iconsPage},
    {QStringLiteral("bars"), gallery::barsPage},
    {QStringLiteral("palette"), gallery::palettePage},
    {QStringLiteral("sheet"), gallery::sheetPage},
    {QStringLiteral("instruments"), gallery::instrumentsPage},
    {QStringLiteral("robot_instruments"), gallery::robotInstrumentsPage},
    {QStringLiteral("sensors"), gallery::sensorsPage},
    {QStringLiteral("empty_sensors"), gallery::emptySensorsPage},
    {QStringLiteral("behaviors"), gallery::behaviorsPage},
    {QStringLiteral("stale"), gallery::stalePage},
    {QStringLiteral("spawned"), gallery::spawnedPage},
    {QStringLiteral("plan"), gallery::planPage},
    {QStringLiteral("narrow_plan"), gallery::narrowPlanPage},
    {QStringLiteral("docked_plan"), gallery::dockedPlanPage},
    {QStringLiteral("whole_plan"), gallery::wholePlanPage},
    {QStringLiteral("plan_text"), gallery::planTextPage},
    {QStringLiteral("empty_plan"), gallery::emptyPlanPage},
    {QStringLiteral("plan_editor"), gallery::planEditorPage},
    {QStringLiteral("narrow_plan_editor"), gallery::narrowPlanEditorPage},
    {QStringLiteral("faulty_plan_editor"), gallery::faultyPlanEditorPage},
};

/// Lets workers deliver and layouts settle before the picture is taken.
void settle() {
    QEventLoop loop;
    QTimer::singleShot(250, &loop, &QEventLoop::quit);
    loop.exec();
}

bool grab(const Page& page, const QDir& folder, widgets::Theme theme) {
    widgets::applyTheme(theme);
    const auto widget = page.make();
    widget->show();
    settle();
    const QString suffix = theme == widgets::Theme::Dark ? QStringLiteral("-dark.png") : QStringLiteral("-light.png");
    return widget->grab().save(folder.filePath(page.name + suffix));
}

} // namespace

int main(int argc, char** argv) {
    if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM"))
        qputenv("QT_QPA_PLATFORM", "offscreen");
    QApplication application(argc, argv);
    const QStringList arguments = QApplication::arguments();
    const QDir folder(arguments.value(1, QStringLiteral("gallery")));
    folder.mkpath(QStringLiteral("."));
    for (const Page& page : pages)
        for (const widgets::Theme theme : {widgets::Theme::Dark, widgets::Theme::Light})
            if ((arguments.size() < 3 || arguments[2] == page.name) && !grab(page, folder, theme)) {
                std::fprintf(stderr, "cannot write %s\n", qPrintable(folder.absolutePath()));
                return 1;
            }
    return 0;
}
