// The worlds of the embedded simulator, as commands.
#include <algorithm>

#include <QDir>
#include <QFileDialog>
#include <QMenu>

#include "app/locations.h"
#include "app/main_window.h"

namespace usar::app {

namespace {

/// "point_lookout" as a menu says it: "Point lookout".
QString titleOf(QString name) {
    name.replace('_', ' ');
    return name.left(1).toUpper() + name.mid(1);
}

} // namespace

void MainWindow::registerWorldCommands() {
    const auto nothing_runs = [this] {
        return std::ranges::none_of(control_.robots(), [](const Robot* robot) { return robot->running(); });
    };
    for (const QString& name : worldNames())
        commands_.add(
            {"world." + name,
             titleOf(name),
             tr("World"),
             tr("Starts the embedded simulator anew in this world; robots there end"),
             "",
             {}},
            [this, name](bool) { chooseWorld(name); }, nothing_runs);
    commands_.add(
        {"world.folder",
         tr("World from a folder…"),
         tr("World"),
         tr("A folder with world.sdf, height.png and plants.csv; see resources/worlds/README.md"),
         "",
         {}},
        [this](bool) {
            const QString folder = QFileDialog::getExistingDirectory(this, tr("World from a folder"), QDir::homePath());
            if (!folder.isEmpty())
                chooseWorld(folder);
        },
        nothing_runs);
}

void MainWindow::registerSnapshotCommands() {
    const QString filter = tr("Snapshots (*.usarsnap)");
    commands_.add(
        {"simulator.save_snapshot",
         tr("Save snapshot…"),
         tr("World"),
         tr("This moment of the embedded simulator, to go on from later, as often as you like"),
         "",
         {}},
        [this, filter](bool) {
            const QString path = QFileDialog::getSaveFileName(this, tr("Save snapshot"), "run.usarsnap", filter);
            if (!path.isEmpty())
                control_.simulator().saveSnapshot(path);
        },
        [this] { return control_.simulator().running(); });
    commands_.add(
        {"simulator.open_snapshot",
         tr("Open snapshot…"),
         tr("World"),
         tr("The embedded simulator goes on from a moment that was saved, with its robots; those that are there end"),
         "",
         {}},
        [this, filter](bool) {
            const QString path = QFileDialog::getOpenFileName(this, tr("Open snapshot"), {}, filter);
            if (!path.isEmpty())
                openSnapshot(path);
        });
    connect(&control_.simulator(), &SimulatorHost::snapshotSaved, this, [this](const QString& path) {
        control_.cure("snapshot");
        say(Severity::Note, "snapshot-saved", tr("Snapshot saved: %1").arg(path));
    });
    connect(&control_.simulator(), &SimulatorHost::snapshotFailed, this,
            [this](const QString& reason) { say(Severity::Error, "snapshot", reason); });
}

void MainWindow::openSnapshot(const QString& path) {
    options_.server.simulator.snapshot = path;
    views_.connection->setServer(widgets::ServerChoice::Embedded);
    connectTo(widgets::ServerChoice::Embedded, {}, 0);
    options_.server.simulator.snapshot.clear(); // another start is from the beginning
    commands_.refresh();
}

void MainWindow::fillWorldMenu(QMenu* menu) {
    QStringList ids;
    for (const QString& name : worldNames())
        ids << "world." + name;
    commands_.fill(menu, ids + QStringList{"-", "world.folder"});
}

} // namespace usar::app
