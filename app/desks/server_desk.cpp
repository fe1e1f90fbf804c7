#include "app/desks/server_desk.h"

#include <algorithm>
#include <map>

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>

#include "core/server/embedded/program_files.h"

namespace usar::app {

namespace {

/// Makes the title of a world for menus: "point_lookout" becomes "Point lookout".
QString titleOf(QString name) {
    name.replace('_', ' ');
    return name.left(1).toUpper() + name.mid(1);
}

widgets::ConnectionStatus barStatus(const link::LinkStatus& status, const QString& where) {
    using widgets::ConnectionState;
    static const std::map<link::LinkState, ConnectionState> states{
        {link::LinkState::Disconnected, ConnectionState::Disconnected},
        {link::LinkState::Connecting, ConnectionState::Connecting},
        {link::LinkState::Connected, ConnectionState::Connected},
        {link::LinkState::Waiting, ConnectionState::Waiting}};
    return {states.at(status.state), where, status.trouble, status.retry_in};
}

} // namespace

ServerDesk::ServerDesk(const DeskContext& context, const ServerTarget& server) : desk_(context), server_(server) {}

void ServerDesk::registerCommands() {
    registerLinkCommands();
    registerWorldCommands();
    registerSnapshotCommands();
    registerRobotFileCommand();
}

void ServerDesk::registerLinkCommands() {
    auto* const bar = desk_.views.connection;
    const auto idle = [this] { return link_state_ == link::LinkState::Disconnected; };
    const auto named = [bar] { return bar->server() == widgets::ServerChoice::Embedded || !bar->host().isEmpty(); };
    desk_.commands.add(
        {"link.connect",
         tr("Connect"),
         tr("Server"),
         tr("To the server that the bar above the map names"),
         "plug",
         {QKeySequence("Ctrl+L")}},
        [this, bar](bool) { connectTo(bar->server(), bar->host(), bar->port()); },
        [idle, named] { return idle() && named(); });
    desk_.commands.add(
        {"link.disconnect",
         tr("Disconnect"),
         tr("Server"),
         tr("Stops the robots, saves what was scanned and leaves the server"),
         "unplug",
         {QKeySequence("Ctrl+Shift+L")}},
        [this](bool) { disconnectFromServer(); }, [idle] { return !idle(); });
}

void ServerDesk::registerWorldCommands() {
    const auto nothing_runs = [this] {
        return std::ranges::none_of(desk_.control.robots(), [](const Robot* robot) { return robot->running(); });
    };
    for (const QString& name : server::worldNames())
        desk_.commands.add(
            {"world." + name,
             titleOf(name),
             tr("World"),
             tr("Starts the embedded simulator anew in this world; robots there end"),
             "",
             {}},
            [this, name](bool) { openWorld(name); }, nothing_runs);
    desk_.commands.add(
        {"world.folder",
         tr("World from a folder…"),
         tr("World"),
         tr("A folder with world.sdf, height.png and plants.csv; see resources/worlds/README.md"),
         "",
         {}},
        [this](bool) {
            const QString folder =
                QFileDialog::getExistingDirectory(desk_.window, tr("World from a folder"), QDir::homePath());
            if (!folder.isEmpty())
                openWorld(folder);
        },
        nothing_runs);
}

void ServerDesk::registerSnapshotCommands() {
    const QString filter = tr("Snapshots (*.usarsnap)");
    desk_.commands.add(
        {"simulator.save_snapshot",
         tr("Save snapshot…"),
         tr("World"),
         tr("This moment of the embedded simulator, to go on from later, as often as you like"),
         "",
         {}},
        [this, filter](bool) {
            const QString path =
                QFileDialog::getSaveFileName(desk_.window, tr("Save snapshot"), "run.usarsnap", filter);
            if (!path.isEmpty())
                desk_.control.simulator().saveSnapshot(path);
        },
        [this] { return desk_.control.simulator().running(); });
    desk_.commands.add(
        {"simulator.open_snapshot",
         tr("Open snapshot…"),
         tr("World"),
         tr("The embedded simulator goes on from a moment that was saved, with its robots; those that are there end"),
         "",
         {}},
        [this, filter](bool) {
            const QString path = QFileDialog::getOpenFileName(desk_.window, tr("Open snapshot"), {}, filter);
            if (!path.isEmpty())
                openSnapshot(path);
        });
    desk_.commands.add(
        {"simulator.cancel_opening",
         tr("Cancel opening"),
         tr("World"),
         tr("Of a world or a snapshot that is on its way; everything stays as it is"),
         "",
         {}},
        [this](bool) { abandonLoading(); }, [this] { return loader_.busy(); });
}

void ServerDesk::registerRobotFileCommand() {
    desk_.commands.add(
        {"simulator.open_robot",
         tr("Robot from a file…"),
         tr("World"),
         tr("The embedded simulator can spawn one more kind of robot; see resources/robots/README.md"),
         "",
         {}},
        [this](bool) {
            const QString path = QFileDialog::getOpenFileName(desk_.window, tr("Robot from a file"), QDir::homePath(),
                                                              tr("Robots (*.sdf)"));
            if (!path.isEmpty())
                openRobotFile(path);
        },
        [this] { return desk_.control.simulator().running(); });
}

void ServerDesk::wire() {
    auto* const bar = desk_.views.connection;
    connect(bar, &widgets::ConnectionBar::connectRequested, this, &ServerDesk::connectTo);
    connect(bar, &widgets::ConnectionBar::disconnectRequested, this, &ServerDesk::disconnectFromServer);
    connect(&desk_.control, &MissionControl::linkChanged, this, &ServerDesk::showLink);
    connect(&desk_.control, &MissionControl::worldKnown, this, &ServerDesk::showWorld);
    connect(&desk_.control, &MissionControl::startPosesKnown, this,
            [bar](const protocol::StartPoses&, const QString& level) {
                bar->setStatus({widgets::ConnectionState::Connected, level, {}, Seconds{0.0}});
            });
    connect(&desk_.control, &MissionControl::robotUpdated, this, [this, bar](int id, const auto& update) {
        const mission::SessionFigures& figures = update->figures;
        if (id == desk_.selection.id())
            bar->setRate(figures.replay ? std::nullopt : std::optional(figures.lines_per_second));
    });
    wireLoading();
    wireSimulator();
}

void ServerDesk::wireLoading() {
    auto* const strip = desk_.views.progress;
    connect(strip, &widgets::ProgressStrip::cancelRequested, this, &ServerDesk::abandonLoading);
    connect(&loader_, &server::SimulationLoader::progressed, strip, &widgets::ProgressStrip::setProgress);
    connect(&loader_, &server::SimulationLoader::loaded, this, &ServerDesk::takeLoaded);
    connect(&loader_, &server::SimulationLoader::refused, this, [this](const QString& reason) {
        desk_.views.progress->end();
        emit loadingEnded();
        desk_.commands.refresh();
        desk_.notices.say(Severity::Error, "simulator", reason);
    });
}

void ServerDesk::wireSimulator() {
    server::SimulatorHost* const simulator = &desk_.control.simulator();
    connect(simulator, &server::SimulatorHost::snapshotSaved, this, [this](const QString& path) {
        desk_.notices.cure("snapshot");
        desk_.notices.say(Severity::Note, "snapshot-saved", tr("Snapshot saved: %1").arg(path));
    });
    connect(simulator, &server::SimulatorHost::snapshotFailed, this,
            [this](const QString& reason) { desk_.notices.say(Severity::Error, "snapshot", reason); });
    connect(simulator, &server::SimulatorHost::robotLearned, this, &ServerDesk::learned);
}

void ServerDesk::restore(const QSettings& settings) {
    // The address is offered if the user chooses a real server. The program itself always starts with the embedded one
    // unless the command line says otherwise.
    desk_.views.connection->setAddress(settings.value("server/host", server_.host).toString(),
                                       quint16(settings.value("server/port", server_.port).toUInt()));
}

void ServerDesk::save(QSettings& settings) const {
    settings.setValue("server/host", desk_.views.connection->host());
    settings.setValue("server/port", desk_.views.connection->port());
}

void ServerDesk::fillWorldMenu(QMenu* menu) const {
    QStringList ids;
    for (const QString& name : server::worldNames())
        ids << "world." + name;
    desk_.commands.fill(menu, ids + QStringList{"-", "world.folder"});
}

void ServerDesk::begin() {
    auto* const bar = desk_.views.connection;
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
    desk_.views.map->clear();
    emit leavingWorld(target.embedded);
    desk_.control.connectTo(target);
    if (desk_.selection.robot()) // A replay remains, but the map was cleared.
        desk_.selection.select(desk_.selection.id());
}

void ServerDesk::disconnectFromServer() {
    cancelLoading();
    desk_.control.disconnectFromServer();
}

void ServerDesk::showLink(const link::LinkStatus& status) {
    link_state_ = status.state;
    desk_.views.connection->setStatus(barStatus(status, desk_.control.level()));
    if (status.state != link::LinkState::Connected)
        desk_.views.connection->setRate(std::nullopt);
}

void ServerDesk::showWorld(const server::WorldPicture& world) {
    desk_.views.map->setWorld(world.extent_in_map, world.name);
    desk_.views.map->setBackground(world.relief, world.extent_in_map);
    desk_.views.map->fitWorld();
}

QString ServerDesk::world() const {
    return desk_.control.level().isEmpty() ? server_.simulator.world : desk_.control.level();
}

void ServerDesk::openRobotFile(const QString& path) {
    if (desk_.control.simulator().running())
        return desk_.control.simulator().learn(path);
    desk_.notices.say(
        Severity::Warning, "robot-file",
        tr("%1 is a robot for the embedded simulator, which does not run. Connect to it first.").arg(path));
}

void ServerDesk::learned(const QString& file, const QString& class_name) {
    QStringList& files = server_.simulator.robot_files;
    files.removeAll(file);
    files << file; // For the next world, too.
    desk_.notices.cure("robot-file");
    desk_.notices.say(Severity::Note, "robot-learned",
                      tr("%1 can be spawned: click a start pose and choose it.").arg(class_name));
}

void ServerDesk::openSnapshot(const QString& path) {
    server::SimulatorSpec spec = server_.simulator;
    spec.snapshot = path;
    load(spec, tr("Taking up %1").arg(QFileInfo(path).fileName()));
}

void ServerDesk::openWorld(const QString& name_or_folder) {
    server::SimulatorSpec spec = server_.simulator;
    spec.world = name_or_folder;
    load(spec, tr("Opening %1").arg(titleOf(QDir(name_or_folder).dirName())));
}

void ServerDesk::load(const server::SimulatorSpec& spec, const QString& what) {
    emit loadingEnded(); // Another world that was still being loaded is given up.
    loader_.load(spec);
    desk_.views.progress->begin(what);
    desk_.commands.refresh();
}

void ServerDesk::takeLoaded(const server::SimulatorSpec& spec) {
    desk_.views.progress->end();
    desk_.notices.cure("simulator");
    const server::SimulatorSpec usual = server_.simulator;
    server_.simulator = spec;
    desk_.views.connection->setServer(widgets::ServerChoice::Embedded);
    connectTo(widgets::ServerChoice::Embedded, {}, 0);
    server_.simulator = usual; // A snapshot is used once; the next start does not resume it.
    if (spec.snapshot.isEmpty())
        server_.simulator.world = spec.world;
    desk_.commands.refresh();
}

void ServerDesk::abandonLoading() {
    emit loadingEnded();
    cancelLoading();
    desk_.notices.say(Severity::Note, "opening-cancelled", tr("Opening was cancelled; everything is as it was."));
}

void ServerDesk::cancelLoading() {
    loader_.giveUp();
    desk_.views.progress->end();
    desk_.commands.refresh();
}

} // namespace usar::app
