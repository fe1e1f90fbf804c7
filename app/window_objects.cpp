// Objects of the world and the marks of robots under TRACE, as the window wires them.
#include "app/main_window.h"

namespace usar::app {

void MainWindow::registerTraceCommands() {
    const auto traceable = [this] {
        const Robot* robot = control_.robot(selected_);
        return robot && robot->view().figures.spawned && !robot->isReplay() &&
               robot->view().figures.dialect != protocol::Dialect::Udk;
    };
    commands_.add(
        {"robot.trace",
         tr("Trace"),
         tr("Robots"),
         tr("The selected robot leaves colored marks where it goes, here and in the game (UT2004 servers)"),
         "trace",
         {QKeySequence("Ctrl+M")},
         true},
        [this](bool on) { trace(on); }, traceable);
    for (const protocol::TraceColor color : widgets::all_trace_colors)
        commands_.add(
            {"robot.trace_" + widgets::traceColorName(color).toLower(),
             tr("Trace in %1").arg(widgets::traceColorName(color).toLower()),
             tr("Robots"),
             tr("The selected robot leaves marks of this color from now on"),
             "",
             {}},
            [this, color](bool) {
                views_.world->setTraceColor(color);
                trace(true);
            },
            traceable);
    commands_.add(
        {"map.wipe_trace",
         tr("Wipe trace marks"),
         tr("Map"),
         tr("Takes the marks of all robots off the map; a game keeps its own"),
         "clear",
         {}},
        [this](bool) {
            views_.map->clearTraceMarks();
            commands_.refresh();
        },
        [this] { return !views_.map->traces().empty(); });
    connect(views_.world, &widgets::WorldPanel::traceColorChosen, this, [this] {
        if (presenter_.tracing(selected_))
            trace(true);
    });
}

void MainWindow::trace(bool on) {
    constexpr Seconds interval{0.2};
    Robot* robot = control_.robot(selected_);
    if (!robot)
        return;
    if (on)
        robot->send(protocol::Trace{true, interval, views_.world->traceColor()}, "operator: trace");
    else
        robot->send(protocol::Trace{false, {}, {}}, "operator: trace");
}

void MainWindow::showTrace() {
    commands_.action("robot.trace")->setChecked(presenter_.tracing(selected_));
    if (const auto color = presenter_.traceColor(selected_); color && presenter_.tracing(selected_))
        views_.world->setTraceColor(*color);
}

void MainWindow::wireObjects() {
    world_.wire();
    connect(&world_, &WorldEditor::noticed, this, [this](const QString& key, const mission::Notice& notice) {
        say(notice.severity, key, QString::fromStdString(notice.text));
    });
    connect(&world_, &WorldEditor::cured, views_.notifications, &widgets::NotificationCenter::cured);
    connect(&control_, &MissionControl::linkChanged, &world_, &WorldEditor::setServer);
    connect(&control_, &MissionControl::worldKnown, &world_, &WorldEditor::setWorld);
    connect(&control_.simulator(), &SimulatorHost::marksLeft, this, [this](const std::vector<sim::TraceMark>& marks) {
        const bool none_before = views_.map->traces().empty();
        for (const sim::TraceMark& mark : marks)
            views_.map->addTraceMark(mark.position_in_map_m.head<2>(), widgets::traceColor(mark.color));
        if (none_before)
            commands_.refresh();
    });
}

} // namespace usar::app
