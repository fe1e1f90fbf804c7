#include "app/desks/replay_desk.h"

#include <QFileDialog>

namespace usar::app {

void ReplayDesk::registerCommands() {
    constexpr Seconds leap{10.0};
    widgets::CommandRegistry& commands = desk_.commands;
    const auto shown = [this] {
        const Robot* robot = desk_.selection.robot();
        return robot && robot->isReplay();
    };
    // Relative to the replay's position when it takes the order: at 100 times the pace the bar lags by seconds.
    const auto seekBy = [this](Seconds span) { return [this, span](bool) { order({.seek_by = span}); }; };
    commands.add({"file.record",
                  tr("Record"),
                  tr("File"),
                  tr("Every byte of each robot into a file in the result folder, for replay"),
                  "record",
                  {QKeySequence("Ctrl+Alt+R")},
                  true},
                 [this](bool on) { setRecording(on); });
    commands.add({"file.open_recording",
                  tr("Open recording…"),
                  tr("File"),
                  tr("Replays it as a robot of its own; dropping the file on the window does the same"),
                  "open",
                  {QKeySequence("Ctrl+Shift+O")}},
                 [this](bool) { chooseRecording(); });
    commands.add(
        {"replay.play",
         tr("Play or pause"),
         tr("Replay"),
         tr("Of the replay that is selected"),
         "play",
         {QKeySequence("Space")}},
        [this](bool) { order({.play = !desk_.views.replay->state().playing}); }, shown);
    commands.add(
        {"replay.step",
         tr("One message on"),
         tr("Replay"),
         tr("Pauses, and plays the next bytes of the server and what they caused"),
         "step",
         {QKeySequence(".")}},
        [this](bool) { order({.step = true}); }, shown);
    commands.add(
        {"replay.back", tr("10 s back"), tr("Replay"), tr("To a moment before"), "back", {QKeySequence("Alt+Left")}},
        seekBy(-leap), shown);
    commands.add({"replay.forward",
                  tr("10 s on"),
                  tr("Replay"),
                  tr("To a moment after"),
                  "forward",
                  {QKeySequence("Alt+Right")}},
                 seekBy(leap), shown);
    commands.add(
        {"replay.begin",
         tr("From the beginning"),
         tr("Replay"),
         tr("Back to the first message"),
         "",
         {QKeySequence("Alt+Home")}},
        [this](bool) { order({.seek = Seconds{0.0}}); }, shown);
    commands.add(
        {"replay.faster", tr("Replay faster"), tr("Replay"), tr("The next speed up"), "", {QKeySequence("Alt+Up")}},
        [this](bool) { desk_.views.replay->changeSpeed(1); }, shown);
    commands.add(
        {"replay.slower", tr("Replay slower"), tr("Replay"), tr("The next speed down"), "", {QKeySequence("Alt+Down")}},
        [this](bool) { desk_.views.replay->changeSpeed(-1); }, shown);
    commands.add(
        {"replay.close", tr("Close the replay"), tr("Replay"), tr("The file stays as it is"), "clear", {}},
        [this](bool) { desk_.control.remove(desk_.selection.id()); }, shown);
}

void ReplayDesk::wire() {
    auto* const bar = desk_.views.replay;
    desk_.views.record->setAction(desk_.commands.action("file.record"));
    bar->setActions(desk_.commands.action("replay.play"), desk_.commands.action("replay.back"),
                    desk_.commands.action("replay.forward"), desk_.commands.action("replay.step"),
                    desk_.commands.action("replay.close"));
    connect(bar, &widgets::ReplayBar::seekRequested, this, [this](Seconds position) { order({.seek = position}); });
    connect(bar, &widgets::ReplayBar::speedRequested, this, [this](double speed) { order({.speed = speed}); });
    connect(&desk_.selection, &Selection::changed, this, &ReplayDesk::show);
    connect(&desk_.control, &MissionControl::robotUpdated, this, [this](int id) {
        if (id == desk_.selection.id())
            show();
    });
}

void ReplayDesk::restore(const QSettings& settings) {
    setRecording(settings.value("record", true).toBool());
}

void ReplayDesk::save(QSettings& settings) const {
    settings.setValue("record", desk_.control.recording());
}

void ReplayDesk::show() {
    const Robot* robot = desk_.selection.robot();
    const bool is_replay = robot && robot->isReplay();
    desk_.views.replay->setVisible(is_replay);
    const mission::SessionFigures figures = robot ? robot->view().figures : mission::SessionFigures{};
    if (is_replay) {
        desk_.views.replay->setFile(robot->view().recording);
        if (figures.replay)
            desk_.views.replay->setState({figures.replay->position, figures.replay->span, figures.replay->speed,
                                          figures.replay->playing, figures.replay->seeking});
    }
    if (figures.recording)
        desk_.views.record->setState(widgets::RecordState{figures.recording->elapsed, figures.recording->bytes,
                                                          QString::fromStdString(figures.recording->path)});
    else
        desk_.views.record->setState(std::nullopt);
}

void ReplayDesk::order(const mission::ReplayOrder& order) {
    if (Robot* robot = desk_.selection.robot(); robot && robot->isReplay())
        robot->orderReplay(order);
}

void ReplayDesk::setRecording(bool on) {
    desk_.control.setRecording(on);
    desk_.commands.action("file.record")->setChecked(on);
    show();
}

void ReplayDesk::chooseRecording() {
    const QString path = QFileDialog::getOpenFileName(desk_.window, tr("Open recording"), desk_.control.resultFolder(),
                                                      tr("Recordings (*.usarrec)"));
    if (!path.isEmpty())
        desk_.control.openRecording(path);
}

} // namespace usar::app
