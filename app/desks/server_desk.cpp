#include "app/desks/server_desk.h"

#include <QDir>
#include <QFileInfo>

#include "core/server/embedded/program_files.h"
#include "widgets/panels/dialogs.h"

namespace usar::app {

void ServerDesk::registerCommands() {
    auto* const bar = views_.connection;
    const auto idle = [this] { return link_state_ == link::LinkState::Disconnected; };
    const auto may_connect = [idle, bar] {
        return idle() && (bar->server() == widgets::ServerChoice::Embedded || !bar->host().isEmpty());
    };
    add("link.connect", may_connect, [this, bar] { connectTo(bar->server(), bar->host(), bar->port()); });
    add(
        "link.disconnect", [idle] { return !idle(); }, [this] { disconnectFromServer(); });
    const auto nothing_runs = [this] { return !control_.anyRunning(); };
    for (const QString& name : server::worldNames())
        add({.id = "world." + name,
             .text = server::worldTitle(name),
             .group = tr("World"),
             .help = tr("Restarts the embedded simulator in this world; the robots in the old world are removed"),
             .words = {name, "load", "map", "scene"},
             .wish = tr("Open world %1").arg(server::worldTitle(name))},
            nothing_runs, [this, name] { openWorld(name); });
    add("world.folder", nothing_runs, [this] {
        widgets::askForFolder(window_, tr("World from a folder"), QDir::homePath(),
                              [this](const QString& folder) { openWorld(folder); });
    });
    registerSimulatorCommands();
}

void ServerDesk::registerSimulatorCommands() {
    const auto running = [this] { return control_.simulator().running(); };
    const QString snapshots = tr("Snapshots (*.usarsnap)");
    add("simulator.save_snapshot", running, [this, snapshots] {
        widgets::askWhereToSave(window_, tr("Save snapshot"), "run.usarsnap", snapshots,
                                [this](const QString& path) { control_.simulator().saveSnapshot(path); });
    });
    add("simulator.open_snapshot", [this, snapshots] {
        widgets::askForFile(window_, tr("Open snapshot"), {}, snapshots,
                            [this](const QString& path) { openSnapshot(path); });
    });
    add(
        "simulator.cancel_opening", [this] { return loader_.busy(); }, [this] { abandonLoading(); });
    add("simulator.open_robot", running, [this] {
        widgets::askForFile(window_, tr("Robot from a file"), QDir::homePath(), tr("Robots (*.sdf)"),
                            [this](const QString& path) { openRobotFile(path); });
    });
}

void ServerDesk::wire() {
    auto* const bar = views_.connection;
    connect(bar, &widgets::ConnectionBar::connectRequested, this, &ServerDesk::connectTo);
    connect(bar, &widgets::ConnectionBar::disconnectRequested, this, &ServerDesk::disconnectFromServer);
    connect(&control_, &MissionControl::linkChanged, this, &ServerDesk::showLink);
    connect(&control_, &MissionControl::worldKnown, this, &ServerDesk::showWorld);
    connect(&control_, &MissionControl::startPosesKnown, this,
            [bar](const protocol::StartPoses&, const QString& level) {
                bar->setStatus({widgets::ConnectionState::Connected, level, {}, Seconds{0.0}});
            });
    connectUpdates([bar](const mission::SessionUpdate& update) {
        bar->setRate(update.figures.replay ? std::nullopt : std::optional(update.figures.lines_per_second),
                     update.figures.round_trip);
    });
    auto* const strip = views_.progress;
    connect(strip, &widgets::ProgressStrip::cancelRequested, this, &ServerDesk::abandonLoading);
    connect(&loader_, &server::SimulationLoader::progressed, strip, &widgets::ProgressStrip::setProgress);
    connect(&loader_, &server::SimulationLoader::loaded, this, &ServerDesk::takeLoaded);
    connect(&loader_, &server::SimulationLoader::refused, this, [this](const QString& reason) {
        views_.progress->end();
        emit loadingEnded();
        commands_.refresh();
        notices_.say(Severity::Error, "simulator", reason);
    });
    server::SimulatorHost* const simulator = &control_.simulator();
    connect(simulator, &server::SimulatorHost::snapshotSaved, this, [this](const QString& path) {
        emit snapshotUsed(path);
        notices_.cure("snapshot");
        notices_.say(Severity::Note, "snapshot-saved", tr("Snapshot saved: %1").arg(path));
    });
    connect(simulator, &server::SimulatorHost::snapshotFailed, this,
            [this](const QString& reason) { notices_.say(Severity::Error, "snapshot", reason); });
    connect(simulator, &server::SimulatorHost::robotLearned, this, &ServerDesk::learned);
}

void ServerDesk::restore(const QSettings& settings) {
    // The address is offered if the user chooses a real server. The program itself always starts with the embedded one
    // unless the command line says otherwise.
    views_.connection->setAddress(settings.value("server/host", server_.host).toString(),
                                  quint16(settings.value("server/port", server_.port).toUInt()));
}

void ServerDesk::save(SettingsSheet& settings) const {
    settings.setValue("server/host", views_.connection->host());
    settings.setValue("server/port", views_.connection->port());
}

void ServerDesk::fillWorldMenu(QMenu* menu) const {
    QStringList ids;
    for (const QString& name : server::worldNames())
        ids << "world." + name;
    commands_.fill(menu, ids + QStringList{"-", "world.folder"});
}

void ServerDesk::begin() {
    auto* const bar = views_.connection;
    bar->setServer(server_.embedded ? widgets::ServerChoice::Embedded : widgets::ServerChoice::Real);
    if (!server_.embedded)
        bar->setAddress(server_.host, server_.port);
    connectTo(bar->server(), server_.host, server_.port);
}

void ServerDesk::connectTo(widgets::ServerChoice choice, const QString& host, quint16 port) {
    ServerTarget target = server_;
    target.embedded = choice == widgets::ServerChoice::Embedded;
    if (!target.embedded) {
        target.host = host;
        target.port = port;
    }
    cancelLoading();
    views_.map->clear();
    views_.spawn_card->hide(); // Its start pose is one of the server that is gone.
    emit leavingWorld(target.embedded);
    control_.connectTo(target);
    if (selection_.robot()) // A replay remains, but the map was cleared.
        selection_.select(selection_.id());
}

void ServerDesk::disconnectFromServer() {
    cancelLoading();
    control_.disconnectFromServer();
}

/// The bar has the same states as a link, in the same order.
void ServerDesk::showLink(const link::LinkStatus& status) {
    link_state_ = status.state;
    const QString open_to = control_.simulator().running() ? server_.simulator.access.networks() : QString();
    views_.connection->setStatus({static_cast<widgets::ConnectionState>(status.state), control_.level(), status.trouble,
                                  status.retry_in, open_to});
    if (status.state != link::LinkState::Connected)
        views_.connection->setRate(std::nullopt);
}

void ServerDesk::showWorld(const server::WorldPicture& world) {
    views_.map->setWorld(world.extent_in_map, world.name, world.scenery);
    views_.map->setBackground(world.relief, world.extent_in_map);
    views_.map->fitWorld();
}

void ServerDesk::openRobotFile(const QString& path) {
    if (control_.simulator().running())
        return control_.simulator().learn(path);
    notices_.say(Severity::Warning, "robot-file",
                 tr("%1 is a robot for the embedded simulator, which does not run. Connect to it first.").arg(path));
}

void ServerDesk::learned(const QString& file, const QString& class_name) {
    QStringList& files = server_.simulator.robot_files;
    files.removeAll(file);
    files << file; // For the next world, too.
    notices_.cure("robot-file");
    notices_.say(Severity::Note, "robot-learned",
                 tr("%1 can be spawned: click a start pose and choose it.").arg(class_name));
}

void ServerDesk::openSnapshot(const QString& path) {
    server::SimulatorSpec spec = server_.simulator;
    spec.snapshot = path;
    load(spec, tr("Taking up %1").arg(QFileInfo(path).fileName()));
}

bool ServerDesk::mayLeaveWorld() {
    if (control_.anyRunning())
        notices_.say(Severity::Warning, "simulator",
                     tr("A robot is on its mission. Stop it, then open another world."));
    return !control_.anyRunning();
}

bool ServerDesk::openRun(const QString& world, quint64 seed, const std::vector<sim::Fault>& faults) {
    if (!mayLeaveWorld())
        return false;
    server::SimulatorSpec spec = server_.simulator;
    spec.world = world;
    spec.seed = seed;
    spec.faults = faults;
    spec.battery_life = sim::survey_battery_life;
    spec.time_begins_with_robots = true;
    load(spec, tr("Opening %1").arg(server::worldTitle(QDir(world).dirName())));
    return true;
}

void ServerDesk::openWorld(const QString& name_or_folder) {
    if (!mayLeaveWorld()) // Maybe a behavior was started after the folder was asked for.
        return;
    server::SimulatorSpec spec = server_.simulator;
    spec.world = name_or_folder;
    load(spec, tr("Opening %1").arg(server::worldTitle(QDir(name_or_folder).dirName())));
}

void ServerDesk::load(const server::SimulatorSpec& spec, const QString& what) {
    emit loadingEnded(); // Another world that was still being loaded is given up.
    loader_.load(spec);
    views_.progress->begin(what);
    commands_.refresh();
}

void ServerDesk::takeLoaded(const server::SimulatorSpec& spec) {
    views_.progress->end();
    notices_.cure("simulator");
    const server::SimulatorSpec usual = server_.simulator;
    server_.simulator = spec;
    views_.connection->setServer(widgets::ServerChoice::Embedded);
    connectTo(widgets::ServerChoice::Embedded, {}, 0);
    server_.simulator = usual; // A snapshot is used once; the next start does not resume it.
    if (spec.snapshot.isEmpty())
        server_.simulator.world = spec.world;
    else
        emit snapshotUsed(spec.snapshot);
    commands_.refresh();
}

void ServerDesk::abandonLoading() {
    emit loadingEnded();
    cancelLoading();
    notices_.say(Severity::Note, "opening-cancelled", tr("Opening was cancelled; everything is as it was."));
}

void ServerDesk::cancelLoading() {
    loader_.giveUp();
    views_.progress->end();
    commands_.refresh();
}

} // namespace usar::app
