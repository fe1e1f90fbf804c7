#include "app/window/main_window.h"

#include <algorithm>
#include <chrono>

#include <QApplication>
#include <QCloseEvent>
#include <QDragEnterEvent>
#include <QMenuBar>
#include <QScreen>
#include <QTimer>

#include "core/base/hand_over.h"
#include "core/mission/fleet/robot_words.h"
#include "core/server/embedded/program_files.h"
#include "widgets/commands/key_filters.h"
#include "widgets/window/window_wiring.h"

namespace usar::app {

MainWindow::MainWindow(const Options& options, QWidget* parent)
    : QMainWindow(parent)
    , options_(options)
    , commands_(this)
    , views_(widgets::makeViews(*this))
    , plugins_(desk_, options.plugin_folders.isEmpty() ? server::pluginFolders() : options.plugin_folders)
    , server_(desk_, options.server)
    , view_(desk_, *this, options.theme) {
    widgets::wireViews(views_);
    control_.setResultFolder(options.result_folder);
    registerCommands();
    makeMenus();
    wire();
    wireDesks();
    connectDesks();
    setAcceptDrops(true);
    new widgets::OwnKeys(this);
    view_.docks().keepFirstLayout();
    restoreSettings();
    selection_.select({});
    plugins_.tellRefused();
    keepSaving();
}

MainWindow::~MainWindow() = default;

void MainWindow::begin() {
    robots_.prefer(options_.select);
    recovery_.offer();
    if (!options_.recording.isEmpty()) {
        views_.time->setSteerable(false); // Until a simulator is connected.
        return files_.openRecording(options_.recording, {.seek = options_.at});
    }
    server_.begin();
    if (!options_.mission_file.isEmpty())
        files_.open(options_.mission_file);
}

void MainWindow::registerCommands() {
    // The palette and the sheet of shortcuts list the commands in this order.
    for (Desk* desk : std::initializer_list<Desk*>{&mission_, &task_, &files_})
        desk->registerCommands();
    commands_.add(widgets::commandSpec("file.quit"), [this](bool) { close(); });
    for (Desk* desk : std::initializer_list<Desk*>{&robots_, &view_, &server_, &time_, &messages_, &replay_, &tests_,
                                                   &faults_, &workshop_, &plan_, &camera_, &drive_, &plugins_, &world_,
                                                   &radio_, &campaign_, &samples_})
        desk->registerCommands();
}

void MainWindow::makeMenus() {
    const auto submenus = widgets::makeMenus(*menuBar(), commands_);
    files_.fillRecentMenu(submenus.at("recent"));
    server_.fillWorldMenu(submenus.at("worlds"));
    view_.layouts().fillMenu(submenus.at("layouts"));
}

void MainWindow::wire() {
    connect(&control_, &MissionControl::readyToClose, this, &MainWindow::closeAtOnce);
    connect(&control_, &MissionControl::exportFailed, this,
            [this](RobotId, const QString& reason) { askWhereToSave(reason); });
    QAction* const stop = commands_.action("mission.stop_all");
    connect(views_.stop_all, &QPushButton::clicked, stop, &QAction::trigger);
    auto* const twice = new widgets::KeyTwice(widgets::commandSpec("mission.stop_all").twice, this);
    connect(twice, &widgets::KeyTwice::pressedTwice, stop, &QAction::trigger);
    connect(views_.map, &widgets::MapView::escapeUsed, twice, &widgets::KeyTwice::forget);
    connect(&commands_, &widgets::CommandRegistry::questionRaised, this,
            [this](const widgets::CommandSpec& spec, const std::function<void()>& run) {
                if (views_.question->openQuestion() == spec.id)
                    return views_.question->give(0); // The key again is a clear answer.
                const QString names = spec.group == "Mission" ? task_.addressees()
                                      : selection_.robot()    ? nameOf(*selection_.robot())
                                                              : QString();
                const QString question = spec.question.arg(names.isEmpty() ? tr("the robot") : names);
                views_.question->ask(spec.id, question, {{spec.answer, run}, {tr("Cancel"), {}}});
            });
    commands_.setPlacesOfPlainKeys({views_.map, views_.robots});
    connect(views_.plots, &widgets::PlotView::failed, this,
            [this](const QString& reason) { notices_.say(Severity::Error, "plot", reason); });
}

void MainWindow::wireDesks() {
    // The desks receive each event in this order: a task is set before it is shown, and the title comes last.
    for (Desk* desk : std::initializer_list<Desk*>{&plugins_,  &server_,  &task_,     &mission_,  &robots_, &plan_,
                                                   &workshop_, &time_,    &drive_,    &camera_,   &world_,  &files_,
                                                   &replay_,   &tests_,   &messages_, &faults_,   &radio_,  &flights_,
                                                   &campaign_, &samples_, &results_,  &recovery_, &view_})
        desk->wire();
    connect(&selection_, &Selection::changed, this, &MainWindow::showTitle);
    connect(&control_, &MissionControl::behaviorFinished, this, [this] {
        showTitle();
        if (leaving_ && !mission::anyRunning(control_.robots()))
            close();
    });
    connect(&control_, &MissionControl::robotUpdated, this, [this](RobotId id) {
        if (id == selection_.id() && !title_rests_.isActive()) {
            showTitle();
            title_rests_.start(std::chrono::seconds(1));
        }
    });
    title_rests_.setSingleShot(true);
    connect(&title_rests_, &QTimer::timeout, this, &MainWindow::showTitle);
    const auto refresh = &widgets::CommandRegistry::refresh;
    connect(&selection_, &Selection::changed, &commands_, refresh);
    connect(&control_, &MissionControl::linkChanged, &commands_, refresh);
    connect(&control_, &MissionControl::worldKnown, &commands_, refresh);
    connect(&control_, &MissionControl::startPosesKnown, &commands_, refresh);
    connect(&control_, &MissionControl::robotLinkChanged, &commands_, refresh);
}

void MainWindow::connectDesks() {
    connect(&server_, &ServerDesk::leavingWorld, &task_, &TaskDesk::leaveWorld);
    connect(&server_, &ServerDesk::leavingWorld, &time_, &TimeDesk::begin);
    connect(&server_, &ServerDesk::loadingEnded, &mission_, &MissionDesk::forgetAwaitedWorld);
    connect(&plugins_, &PluginDesk::changed, &robots_, &RobotDesk::listClasses);
    connect(&plugins_, &PluginDesk::changed, this, [this] { selection_.select(selection_.id()); });
    connect(&plugins_, &PluginDesk::changed, &mission_, &MissionDesk::takePlugins);
    connect(&task_, &TaskDesk::begun, &plan_, &PlanDesk::begin);
    connect(&task_, &TaskDesk::begun, &robots_, &RobotDesk::showRow);
    connect(&task_, &TaskDesk::begun, &results_, &ResultDesk::forget);
    connect(&task_, &TaskDesk::faultsWanted, &faults_, &FaultDesk::begin);
    connect(&task_, &TaskDesk::situationChanged, &workshop_, &PlanWorkshop::follow);
    connect(&workshop_, &PlanWorkshop::planChosen, &task_, &TaskDesk::takePlan);
    connect(&plan_, &PlanDesk::planShown, &workshop_, &PlanWorkshop::setRunningPlan);
    connect(&time_, &TimeDesk::pausedChanged, &world_, &WorldEditor::setPaused);
    connect(&time_, &TimeDesk::pausedChanged, views_.sensors, &widgets::SensorPanel::setPaused);
    connect(&flights_, &RunFlights::togetherWanted, &replay_, &ReplayDesk::keepTogether);
    const auto open = [this](const QString& path) { files_.openRecording(path); };
    connect(&replay_, &ReplayDesk::recordingChosen, &files_, open);
    connect(&recovery_, &RecoveryDesk::recordingChosen, &files_, open);
    connect(&recovery_, &RecoveryDesk::restChosen, &mission_, &MissionDesk::flyRest);
    connect(&drive_, &DriveDesk::realTimeWanted, &time_, &TimeDesk::slowDown);
    connect(&drive_, &DriveDesk::drivingChanged, &world_, &WorldEditor::setDriving);
}

void MainWindow::resizeEvent(QResizeEvent* event) {
    QMainWindow::resizeEvent(event);
    widgets::fitBars(views_, width() / fontMetrics().horizontalAdvance(u'0'));
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    if (!FileDesk::fileIn(*event->mimeData()).isEmpty())
        event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
    const QString path = FileDesk::fileIn(*event->mimeData());
    if (path.isEmpty())
        return;
    event->acceptProposedAction();
    files_.open(path);
}

void MainWindow::restoreSettings() {
    const QSettings settings;
    for (Desk* desk : std::initializer_list<Desk*>{&view_, &messages_, &workshop_, &server_, &replay_, &plan_, &task_,
                                                   &camera_, &files_, &tests_})
        desk->restore(settings);
}

void MainWindow::saveSettings() {
    SettingsSheet sheet;
    for (const Desk* desk : std::initializer_list<const Desk*>{&view_, &plugins_, &messages_, &workshop_, &server_,
                                                               &replay_, &plan_, &task_, &camera_, &files_, &tests_})
        desk->save(sheet);
    const QVariantMap changed = sheet.changedSince(saved_);
    saved_ = sheet;
    if (changed.isEmpty())
        return;
    disk_.start(HandedOver([changed, file = settings_file_] { SettingsSheet::write(changed, file); }));
}

void MainWindow::keepSaving() {
    disk_.setMaxThreadCount(1); // Newer settings are written later.
    auto* const second = new QTimer(this);
    connect(second, &QTimer::timeout, this, [this] {
        recovery_.mark();
        if (isVisible())
            saveSettings();
    });
    second->start(std::chrono::seconds(1));
}

void MainWindow::showTitle() {
    const Robot* robot = selection_.robot();
    const QString progress =
        robot && robot->running() ? mission::titleText(robot->view(), robot->coverage_pct()) : QString();
    const QString program = QApplication::applicationName();
    const QString title = progress.isEmpty() ? program : progress + " – " + program;
    if (title != windowTitle())
        setWindowTitle(title);
}

void MainWindow::askWhereToSave(const QString& reason) {
    if (!control_.closing())
        return;          // The notification reports it, and the scan is still in memory.
    control_.stayOpen(); // Until there is an answer; robots that start meanwhile are asked about again.
    may_stop_ = false;
    leaving_ = false;
    views_.question->ask("unsaved", reason,
                         {{tr("Choose another folder…"), [this] { files_.chooseResultFolder([this] { close(); }); }},
                          {tr("Close without saving"), [this] { closeAtOnce(); }},
                          {tr("Keep the window open"), {}}});
}

void MainWindow::quit() {
    may_stop_ = true;
    close();
}

void MainWindow::askBeforeStopping(int busy) {
    const auto land = [this] {
        leaving_ = true;
        mission::orderAll(control_.robots(), agent::Order::LandNow);
    };
    views_.question->ask("quit", busy == 1 ? tr("A robot is at work.") : tr("%1 robots are at work.").arg(busy),
                         {{tr("Land, then quit"), land},
                          {tr("Stop and quit"), [this] { quit(); }},
                          {tr("Stay"), [this] { leaving_ = false; }}});
}

void MainWindow::closeAtOnce() {
    may_close_ = true;
    close();
}

void MainWindow::closeEvent(QCloseEvent* event) {
    if (workshop_.hasChanges()) {
        event->ignore();
        return workshop_.editor()->letGo([this] { close(); });
    }
    saveSettings();
    drive_.leave();
    server_.cancelLoading(); // Its result is not needed any more.
    const auto busy = std::ranges::count_if(control_.robots(), &Robot::running);
    if (may_close_ || (busy == 0 && !control_.anythingToSave()))
        return event->accept();
    event->ignore();
    if (control_.closing())
        return;
    if (busy > 0 && !may_stop_)
        return askBeforeStopping(static_cast<int>(busy));
    notices_.say(Severity::Note, "closing", tr("Saving what was scanned, then closing…"));
    control_.prepareToClose();
}

} // namespace usar::app
