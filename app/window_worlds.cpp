// The worlds of the embedded simulator, as commands.
#include <algorithm>

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
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
    commands_.add(
        {"simulator.cancel_opening",
         tr("Cancel opening"),
         tr("World"),
         tr("Of a world or a snapshot that is on its way; everything stays as it is"),
         "",
         {}},
        [this](bool) { abandonLoading(); }, [this] { return loader_.busy(); });
    connect(&control_.simulator(), &SimulatorHost::snapshotSaved, this, [this](const QString& path) {
        control_.cure("snapshot");
        say(Severity::Note, "snapshot-saved", tr("Snapshot saved: %1").arg(path));
    });
    connect(&control_.simulator(), &SimulatorHost::snapshotFailed, this,
            [this](const QString& reason) { say(Severity::Error, "snapshot", reason); });
}

void MainWindow::registerRobotFileCommand() {
    commands_.add(
        {"simulator.open_robot",
         tr("Robot from a file…"),
         tr("World"),
         tr("The embedded simulator can spawn one more kind of robot; see resources/robots/README.md"),
         "",
         {}},
        [this](bool) {
            const QString path =
                QFileDialog::getOpenFileName(this, tr("Robot from a file"), QDir::homePath(), tr("Robots (*.sdf)"));
            if (!path.isEmpty())
                openRobotFile(path);
        },
        [this] { return control_.simulator().running(); });
    connect(&control_.simulator(), &SimulatorHost::robotLearned, this,
            [this](const QString& file, const QString& class_name, bool has_camera) {
                QStringList& files = options_.server.simulator.robot_files;
                files.removeAll(file);
                files << file; // for the next world, too
                for (auto [classes, is_one] : {std::pair(&world_picture_.robot_classes, true),
                                               std::pair(&world_picture_.camera_classes, has_camera)}) {
                    classes->removeAll(class_name);
                    if (is_one)
                        classes->append(class_name);
                }
                views_.spawn_card->setRobots(robotsToSpawn(world_picture_.robot_classes));
                camera_->setCameraClasses(world_picture_.camera_classes);
                control_.cure("robot-file");
                say(Severity::Note, "robot-learned",
                    tr("%1 can be spawned: click a start pose and choose it.").arg(class_name));
            });
}

void MainWindow::openRobotFile(const QString& path) {
    if (control_.simulator().running())
        return control_.simulator().learn(path);
    say(Severity::Warning, "robot-file",
        tr("%1 is a robot for the embedded simulator, which does not run. Connect to it first.").arg(path));
}

void MainWindow::openSnapshot(const QString& path) {
    SimulatorSpec spec = options_.server.simulator;
    spec.snapshot = path;
    load(spec, tr("Taking up %1").arg(QFileInfo(path).fileName()));
}

void MainWindow::chooseWorld(const QString& name_or_folder) {
    awaiting_world_.reset();
    SimulatorSpec spec = options_.server.simulator;
    spec.world = name_or_folder;
    load(spec, tr("Opening %1").arg(titleOf(QDir(name_or_folder).dirName())));
}

void MainWindow::wireLoading() {
    connect(views_.progress, &widgets::ProgressStrip::cancelRequested, this, &MainWindow::abandonLoading);
    connect(&loader_, &SimulationLoader::progressed, views_.progress, &widgets::ProgressStrip::setProgress);
    connect(&loader_, &SimulationLoader::loaded, this, &MainWindow::takeLoaded);
    connect(&loader_, &SimulationLoader::refused, this, [this](const QString& reason) {
        views_.progress->end();
        awaiting_world_.reset();
        commands_.refresh();
        say(Severity::Error, "simulator", reason);
    });
}

void MainWindow::load(const SimulatorSpec& spec, const QString& what) {
    loader_.load(spec);
    views_.progress->begin(what);
    commands_.refresh();
}

void MainWindow::takeLoaded(const SimulatorSpec& spec) {
    views_.progress->end();
    control_.cure("simulator");
    const SimulatorSpec usual = options_.server.simulator;
    options_.server.simulator = spec;
    views_.connection->setServer(widgets::ServerChoice::Embedded);
    connectTo(widgets::ServerChoice::Embedded, {}, 0);
    options_.server.simulator = usual; // another start is from the beginning, and the snapshot's world only its own
    if (spec.snapshot.isEmpty())
        options_.server.simulator.world = spec.world;
    commands_.refresh();
}

void MainWindow::abandonLoading() {
    awaiting_world_.reset();
    cancelLoading();
    say(Severity::Note, "opening-cancelled", tr("Opening was cancelled; everything is as it was."));
}

void MainWindow::cancelLoading() {
    loader_.giveUp();
    views_.progress->end();
    commands_.refresh();
}

void MainWindow::fillWorldMenu(QMenu* menu) {
    QStringList ids;
    for (const QString& name : worldNames())
        ids << "world." + name;
    commands_.fill(menu, ids + QStringList{"-", "world.folder"});
}

} // namespace usar::app
