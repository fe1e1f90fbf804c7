// Recording and replay in the window: commands, the bar, files that are dropped.
#include <algorithm>

#include <QDragEnterEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QMimeData>
#include <QUrl>

#include "app/main_window.h"

namespace usar::app {

namespace {

/// The one file of ours that is dragged, or nothing.
QString fileOf(const QMimeData& data) {
    if (data.urls().size() != 1)
        return {};
    const QString path = data.urls().first().toLocalFile();
    const bool known = path.endsWith(".usarrec") || path.endsWith(".usarsnap") || path.endsWith(".json") ||
                       path.endsWith(".sdf") || path.endsWith(".lap") || QFileInfo(path + "/world.sdf").isFile();
    return known ? path : QString();
}

} // namespace

void MainWindow::registerReplayCommands() {
    constexpr Seconds leap{10.0};
    const auto shown = [this] {
        const Robot* robot = control_.robot(selected_);
        return robot && robot->isReplay();
    };
    commands_.add({"file.record",
                   tr("Record"),
                   tr("File"),
                   tr("Every byte of each robot into a file in the result folder, for replay"),
                   "record",
                   {QKeySequence("Ctrl+Alt+R")},
                   true},
                  [this](bool on) { setRecording(on); });
    commands_.add({"file.open_recording",
                   tr("Open recording…"),
                   tr("File"),
                   tr("Replays it as a robot of its own; dropping the file on the window does the same"),
                   "open",
                   {QKeySequence("Ctrl+Shift+O")}},
                  [this](bool) { chooseRecording(); });
    commands_.add(
        {"replay.play",
         tr("Play or pause"),
         tr("Replay"),
         tr("Of the replay that is selected"),
         "play",
         {QKeySequence("Space")}},
        [this](bool) { orderReplay({.play = !views_.replay->state().playing}); }, shown);
    commands_.add(
        {"replay.step",
         tr("One message on"),
         tr("Replay"),
         tr("Pauses, and plays the next bytes of the server and what they caused"),
         "step",
         {QKeySequence(".")}},
        [this](bool) { orderReplay({.step = true}); }, shown);
    commands_.add(
        {"replay.back", tr("10 s back"), tr("Replay"), tr("To a moment before"), "back", {QKeySequence("Alt+Left")}},
        [this, leap](bool) { seekBy(-leap); }, shown);
    commands_.add(
        {"replay.forward",
         tr("10 s on"),
         tr("Replay"),
         tr("To a moment after"),
         "forward",
         {QKeySequence("Alt+Right")}},
        [this, leap](bool) { seekBy(leap); }, shown);
    commands_.add(
        {"replay.begin",
         tr("From the beginning"),
         tr("Replay"),
         tr("Back to the first message"),
         "",
         {QKeySequence("Alt+Home")}},
        [this](bool) { orderReplay({.seek = Seconds{0.0}}); }, shown);
    commands_.add(
        {"replay.faster", tr("Replay faster"), tr("Replay"), tr("The next speed up"), "", {QKeySequence("Alt+Up")}},
        [this](bool) { views_.replay->changeSpeed(1); }, shown);
    commands_.add(
        {"replay.slower", tr("Replay slower"), tr("Replay"), tr("The next speed down"), "", {QKeySequence("Alt+Down")}},
        [this](bool) { views_.replay->changeSpeed(-1); }, shown);
    commands_.add(
        {"replay.close", tr("Close the replay"), tr("Replay"), tr("The file stays as it is"), "clear", {}},
        [this](bool) { control_.remove(selected_); }, shown);
}

void MainWindow::wireReplay() {
    setAcceptDrops(true);
    views_.record->setAction(commands_.action("file.record"));
    views_.replay->setActions(commands_.action("replay.play"), commands_.action("replay.back"),
                              commands_.action("replay.forward"), commands_.action("replay.step"),
                              commands_.action("replay.close"));
    connect(views_.replay, &widgets::ReplayBar::seekRequested, this,
            [this](Seconds position) { orderReplay({.seek = position}); });
    connect(views_.replay, &widgets::ReplayBar::speedRequested, this,
            [this](double speed) { orderReplay({.speed = speed}); });
    connect(&control_, &MissionControl::replayAdded, this, [this](int id) {
        const int flies = control_.lookedBackOn(id);
        if (flies == selected_)
            keepDraft();
        drafts_[id] = drafts_[flies]; // what is set up is not the replay's
        if (flies == 0)
            drafts_[id].area_in_map.reset();
    });
}

void MainWindow::showReplay() {
    const Robot* robot = control_.robot(selected_);
    const bool is_replay = robot && robot->isReplay();
    views_.replay->setVisible(is_replay);
    const mission::SessionFigures figures = robot ? robot->view().figures : mission::SessionFigures{};
    if (is_replay) {
        views_.replay->setFile(robot->view().recording);
        if (figures.replay)
            views_.replay->setState({figures.replay->position, figures.replay->span, figures.replay->speed,
                                     figures.replay->playing, figures.replay->seeking});
    }
    if (figures.recording)
        views_.record->setState(widgets::RecordState{figures.recording->elapsed, figures.recording->bytes,
                                                     QString::fromStdString(figures.recording->path)});
    else
        views_.record->setState(std::nullopt);
}

void MainWindow::orderReplay(const mission::ReplayOrder& order) {
    if (Robot* robot = control_.robot(selected_); robot && robot->isReplay())
        robot->orderReplay(order);
}

void MainWindow::seekBy(Seconds span) {
    orderReplay({.seek_by = span}); // from where it is by then: at 100 times the pace the bar is seconds behind
}

void MainWindow::setRecording(bool on) {
    control_.setRecording(on);
    commands_.action("file.record")->setChecked(on);
    showReplay();
}

void MainWindow::chooseRecording() {
    const QString path =
        QFileDialog::getOpenFileName(this, tr("Open recording"), control_.resultFolder(), tr("Recordings (*.usarrec)"));
    if (!path.isEmpty())
        openRecording(path);
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    if (!fileOf(*event->mimeData()).isEmpty())
        event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
    const QString path = fileOf(*event->mimeData());
    if (path.isEmpty())
        return;
    event->acceptProposedAction();
    openFile(path);
}

void MainWindow::openFile(const QString& path) {
    const QFileInfo file(path);
    const bool is_world = file.isDir() || file.fileName() == "world.sdf";
    const bool flies = std::ranges::any_of(control_.robots(), [](const Robot* robot) { return robot->running(); });
    if (is_world && flies)
        return say(Severity::Warning, "simulator", tr("A robot is on its mission. Stop it, then open another world."));
    if (path.endsWith(".usarsnap"))
        openSnapshot(path);
    else if (path.endsWith(".usarrec"))
        openRecording(path);
    else if (is_world)
        chooseWorld(file.isDir() ? path : file.absolutePath());
    else if (path.endsWith(".sdf"))
        openRobotFile(path);
    else if (path.endsWith(".lap"))
        openPlan(path);
    else
        openMission(path);
}

} // namespace usar::app
