// mission-control: reads the command line, makes the window and runs the event loop.
#include <algorithm>
#include <cstdio>
#include <span>
#include <string_view>

#include <QApplication>
#include <QThreadPool>

#include "app/window/main_window.h"
#include "core/base/version.h"
#include "core/server/embedded/quiet_qt.h"
#include "core/server/embedded/quit_signals.h"
#include "core/server/embedded/simulator_files.h"
#include "core/usage/help_text.h"

namespace {

/// The arguments before there is an application, which would need a display.
QStringList textsOf(int argc, const char* const* argv) {
    QStringList texts;
    for (const char* const text : std::span(argv, static_cast<std::size_t>(argc)))
        texts << QString::fromLocal8Bit(text);
    return texts;
}

/// True if Qt would find no screen to show a window on.
bool lacksDisplay(int argc, const char* const* argv) {
    const auto is_set = [](const char* name) { return !qEnvironmentVariableIsEmpty(name); };
    return !is_set("DISPLAY") && !is_set("WAYLAND_DISPLAY") && !is_set("QT_QPA_PLATFORM") &&
           std::ranges::count(std::span(argv, static_cast<std::size_t>(argc)), std::string_view("-platform")) == 0;
}

} // namespace

int main(int argc, char** argv) {
    usar::server::keepQtQuiet();
    if (usar::answersVersion(argc, argv))
        return 0;
    if (const auto help = usar::usage::answerToHelp(usar::server::windowProgram(), textsOf(argc, argv).mid(1))) {
        std::printf("%s", qPrintable(*help));
        return 0;
    }
    if (lacksDisplay(argc, argv)) {
        std::fprintf(stderr, "mission-control: there is no display (DISPLAY is not set). To fly a mission without a "
                             "window, run: usar-mission run MISSION.json\n");
        return 2;
    }
    QApplication application(argc, argv);
    QApplication::setApplicationName("Mission Control");
    QApplication::setOrganizationName("USAR");
    QApplication::setApplicationVersion(USAR_VERSION);
    QApplication::setDesktopFileName("usar-mission-control"); // by which the desktop finds the icon of the window

    const auto options = usar::server::readWindowOptions(QApplication::arguments());
    if (!options) {
        std::fprintf(stderr, "mission-control: %s\n", options.error().text().c_str());
        return 2;
    }
    if (options->server.embedded && options->recording.isEmpty()) // Reading them takes as long as making the window.
        QThreadPool::globalInstance()->start([] { usar::server::loadRobots(); });
    usar::server::QuitSignals signals_;
    usar::app::MainWindow window(*options);
    QObject::connect(&signals_, &usar::server::QuitSignals::quit, &window, &usar::app::MainWindow::quit);
    window.show();
    window.begin();
    return QApplication::exec();
}
