// Link, time and layout commands of the window, and what it remembers between starts.
#include <cmath>
#include <limits>
#include <memory>

#include <QSettings>

#include "app/main_window.h"

namespace usar::app {

void MainWindow::registerLinkCommands() {
    const auto idle = [this] { return link_state_ == link::LinkState::Disconnected; };
    const auto named = [this] {
        return views_.connection->server() == widgets::ServerChoice::Embedded || !views_.connection->host().isEmpty();
    };
    commands_.add(
        {"link.connect",
         tr("Connect"),
         tr("Server"),
         tr("To the server that the bar above the map names"),
         "plug",
         {QKeySequence("Ctrl+L")}},
        [this](bool) { connectTo(views_.connection->server(), views_.connection->host(), views_.connection->port()); },
        [idle, named] { return idle() && named(); });
    commands_.add(
        {"link.disconnect",
         tr("Disconnect"),
         tr("Server"),
         tr("Stops the robots, saves what was scanned and leaves the server"),
         "unplug",
         {QKeySequence("Ctrl+Shift+L")}},
        [this](bool) { disconnectFromServer(); }, [idle] { return !idle(); });
}

void MainWindow::registerTimeCommands() {
    const auto steerable = [this] { return control_.simulator().running(); };
    commands_.add(
        {"time.pause",
         tr("Pause or run the simulator"),
         tr("Time"),
         tr("Stops simulated time for all robots, or lets it run on"),
         "pause",
         {QKeySequence("Ctrl+P")}},
        [this](bool) { pauseTime(!views_.time->paused()); }, steerable);
    commands_.add(
        {"time.step",
         tr("One tick"),
         tr("Time"),
         tr("One tick of the simulator, while it is paused"),
         "step",
         {QKeySequence("F10")}},
        [this](bool) { stepTime(); }, [this, steerable] { return steerable() && views_.time->paused(); });
    commands_.add(
        {"time.faster", tr("Faster"), tr("Time"), tr("The next speed up"), "", {QKeySequence("Ctrl+Shift+Up")}},
        [this](bool) { views_.time->changeSpeed(1); }, steerable);
    commands_.add(
        {"time.slower", tr("Slower"), tr("Time"), tr("The next speed down"), "", {QKeySequence("Ctrl+Shift+Down")}},
        [this](bool) { views_.time->changeSpeed(-1); }, steerable);
    commands_.add(
        {"time.real", tr("Real time"), tr("Time"), tr("One second a second"), "", {QKeySequence("Ctrl+1")}},
        [this](bool) { setSpeed(1.0); }, steerable);
    commands_.add(
        {"time.max",
         tr("As fast as possible"),
         tr("Time"),
         tr("As fast as this machine can; robots notice nothing"),
         "",
         {QKeySequence("Ctrl+0")}},
        [this](bool) { setSpeed(std::numeric_limits<double>::infinity()); }, steerable);
}

void MainWindow::registerLayoutCommands() {
    commands_.add({"view.operate",
                   tr("Layout: operate"),
                   tr("View"),
                   tr("All docks where they were at first, the map largest"),
                   "reset",
                   {QKeySequence("Ctrl+F1")}},
                  [this](bool) { arrange("plots", 0.25); });
    commands_.add({"view.analyse",
                   tr("Layout: analyse"),
                   tr("View"),
                   tr("Plots large, below a small map"),
                   "plot",
                   {QKeySequence("Ctrl+F2")}},
                  [this](bool) { arrange("plots", 0.6); });
    commands_.add({"view.debug",
                   tr("Layout: debug"),
                   tr("View"),
                   tr("Messages large, below a small map"),
                   "message",
                   {QKeySequence("Ctrl+F3")}},
                  [this](bool) { arrange("messages", 0.6); });
    commands_.add({"view.plan",
                   tr("Layout: plan"),
                   tr("View"),
                   tr("The plan of the selected robot large, below a small map"),
                   "",
                   {QKeySequence("Ctrl+F4")}},
                  [this](bool) { arrange("plan", 0.6); });
    for (QDockWidget* dock : views_.docks) {
        connect(dock->toggleViewAction(), &QAction::triggered, dock, [dock](bool shown) {
            if (shown)
                dock->raise(); // it may be one of several tabs
        });
        commands_.adopt({"view.dock." + dock->objectName(),
                         dock->windowTitle(),
                         tr("View"),
                         tr("Shows or hides this dock"),
                         "",
                         {}},
                        dock->toggleViewAction());
    }
}

void MainWindow::arrange(const QString& raised, double bottom_part) {
    restoreState(first_layout_, layout_version);
    auto* dock = findChild<QDockWidget*>(raised);
    dock->raise();
    resizeDocks({dock}, {static_cast<int>(std::lround(bottom_part * centralWidget()->parentWidget()->height()))},
                Qt::Vertical);
}

/// The time's controls before words that can be done without: what a bar has no room for goes behind its arrow.
void MainWindow::resizeEvent(QResizeEvent* event) {
    QMainWindow::resizeEvent(event);
    using widgets::BarRoom;
    const int columns = width() / fontMetrics().horizontalAdvance(u'0');
    constexpr int least_wide = 175;
    constexpr int least_medium = 150;
    views_.connection->setRoom(columns >= least_wide     ? BarRoom::Wide
                               : columns >= least_medium ? BarRoom::Medium
                                                         : BarRoom::Narrow);
    views_.record->setFiguresShown(columns >= least_medium);
    views_.driver->setRoomy(columns >= least_medium);
}

void MainWindow::restoreSettings() {
    const QSettings settings;
    const QString theme = settings.value("theme", "dark").toString();
    setTheme(options_.theme.value_or(theme == "light" ? widgets::Theme::Light : widgets::Theme::Dark));
    restoreGeometry(settings.value("geometry").toByteArray());
    restoreState(settings.value("layout").toByteArray(), layout_version);
    views_.hint->setVisible(!settings.value("hint_dismissed", false).toBool());
    restoreMessages();
    workshop_.restore(settings);
    views_.layers->restoreState(settings.value("layers").toByteArray());
    // Offered where a real server is chosen; a start without a word about it always shows the embedded world.
    views_.connection->setAddress(settings.value("server/host", options_.server.host).toString(),
                                  quint16(settings.value("server/port", options_.server.port).toUInt()));
    setRecording(settings.value("record", true).toBool());
    plan_.restore(settings);
    if (options_.result_folder.isEmpty())
        control_.setResultFolder(settings.value("result_folder").toString());
}

/// Written by a thread of the pool: a busy disk takes seconds for it.
void MainWindow::saveSettings() {
    auto written = std::make_shared<QSettings>();
    QSettings& settings = *written;
    settings.setValue("theme", widgets::currentTheme() == widgets::Theme::Light ? "light" : "dark");
    settings.setValue("geometry", saveGeometry());
    settings.setValue("isolated_plugins", isolated_plugins_);
    settings.setValue("layout", saveState(layout_version));
    settings.setValue("hint_dismissed", views_.hint->isHidden());
    saveMessages(settings);
    workshop_.save(settings);
    settings.setValue("layers", views_.layers->saveState());
    settings.setValue("server/host", views_.connection->host());
    settings.setValue("server/port", views_.connection->port());
    settings.setValue("record", control_.recording());
    plan_.save(settings);
    if (options_.result_folder.isEmpty() && control_.resultFolderChosen())
        settings.setValue("result_folder", control_.resultFolder());
    written->moveToThread(nullptr); // whoever deletes it writes it
    disk_.start([written = std::move(written)]() mutable { written.reset(); });
}

} // namespace usar::app
