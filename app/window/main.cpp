// mission-control: reads the command line, makes the window and runs the event loop.
#include <cstdio>

#include <QApplication>
#include <QThreadPool>

#include "app/window/main_window.h"
#include "core/server/embedded/quit_signals.h"
#include "core/server/embedded/simulator_files.h"

int main(int argc, char** argv) {
    QApplication application(argc, argv);
    QApplication::setApplicationName("Mission Control");
    QApplication::setOrganizationName("USAR");
    QApplication::setApplicationVersion(USAR_VERSION);

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
