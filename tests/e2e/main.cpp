// The real window, under an application that times each event.
#include "tests/e2e/gui_watchdog.h"
#include "tests/suite/suite.h"

int main(int argc, char** argv) {
    const GuiWatchdog application(argc, argv);
    QApplication::setApplicationName("Mission Control");
    QApplication::setOrganizationName("USAR");
    return usar::test::runTests(argc, argv);
}
