#include "app/desks/drive_desk.h"

#include <algorithm>

#include "app/views/robot_presenter.h"
#include "core/mission/fleet/robot_name.h"
#include "core/mission/hand/hand_cause.h"
#include "core/protocol/commands/spawn.h"

namespace usar::app {

namespace {

using mission::HandSource;
using mission::Reins;

constexpr int beat_ms = 50;
constexpr double speed_step = 0.1;

} // namespace

DriveDesk::DriveDesk(const DeskContext& context)
    : control_(context.control)
    , views_(context.views)
    , commands_(context.commands)
    , selection_(context.selection)
    , notices_(context.notices)
    , keys_(context.window) {
    clock_.start();
    beat_.setInterval(beat_ms);
    beat_.setTimerType(Qt::PreciseTimer);
    connect(&beat_, &QTimer::timeout, this, &DriveDesk::repeat);
    connect(&keys_, &widgets::DriveKeys::changed, this, [this](const Stick& stick) { ask(HandSource::Keys, stick); });
    connect(&keys_, &widgets::DriveKeys::stopPressed, this, [this] { letGo(tr("Space was pressed")); });
    connect(&keys_, &widgets::DriveKeys::focusLost, this, [this] {
        if (!requests_.held().empty())
            letGo(tr("the window lost the focus"));
    });
    connect(views_.drive, &widgets::DrivePanel::moved, this,
            [this](const Stick& stick) { ask(HandSource::Pad, stick); });
    connect(views_.drive, &widgets::DrivePanel::takeRequested, this, &DriveDesk::requestControl);
    connect(views_.drive, &widgets::DrivePanel::stopRequested, this, &DriveDesk::stopRobot);
    connect(views_.drive, &widgets::DrivePanel::speedShareChanged, this, &DriveDesk::repeat);
    wireGamepad();
}

void DriveDesk::registerCommands() {
    const QString group = tr("Drive");
    const auto drives = [this] { return taken(); };
    commands_.add(
        {"drive.take",
         tr("Drive by hand"),
         group,
         tr("Takes control of the selected robot, or gives it back; a running behavior is paused"),
         "hand",
         {QKeySequence("G")},
         true},
        [this](bool on) { requestControl(on); }, [this] { return live(); });
    commands_.add(
        {"drive.stop", tr("Stop driving"), group, tr("At once; Space does the same while you drive"), "stop", {}},
        [this](bool) { letGo(tr("the person stopped it")); }, drives);
    commands_.add(
        {"drive.faster", tr("Drive faster"), group, tr("More speed at the whole stick"), "", {QKeySequence("]")}},
        [this](bool) { setSpeedShare(speedShare() + speed_step); }, drives);
    commands_.add(
        {"drive.slower", tr("Drive slower"), group, tr("Less speed at the whole stick"), "", {QKeySequence("[")}},
        [this](bool) { setSpeedShare(speedShare() - speed_step); }, drives);
    show();
}

void DriveDesk::wire() {
    connect(&selection_, &Selection::changed, this, &DriveDesk::select);
    connect(&control_, &MissionControl::robotUpdated, this, [this](int id, const auto& update) { take(id, *update); });
    connect(&control_, &MissionControl::robotLinkChanged, this, &DriveDesk::refresh);
    connect(views_.driver, &widgets::ControlBadge::clicked, this, &DriveDesk::openDock);
    connect(&gamepad_, &Gamepad::plugged, this,
            [this](const QString& name) { notices_.note("gamepad", tr("The gamepad %1 is plugged in.").arg(name)); });
}

void DriveDesk::openDock() {
    views_.drive_dock->show();
    views_.drive_dock->raise();
}

bool DriveDesk::live() const {
    const Robot* const here = robot();
    return here && !here->isReplay() && here->view().figures.spawned &&
           here->view().link.state == link::LinkState::Connected && !protocol::isStation(here->view().spawn.class_name);
}

double DriveDesk::speedShare() const {
    return views_.drive->speedShare();
}

void DriveDesk::setSpeedShare(double share) {
    views_.drive->setSpeedShare(std::clamp(share, 0.05, 1.0));
}

void DriveDesk::select(int id) {
    if (id != selected_)
        leave();
    selected_ = id;
    velocity_ = {};
    views_.drive->setEcho({});
    views_.drive->setVelocity({}, false);
    show();
}

void DriveDesk::leave() {
    if (taken() && robot()) {
        letGo(tr("another robot was selected"));
        robot()->giveControlBack();
    }
    endControl();
}

void DriveDesk::beginControl() {
    if (requests_.take(wall()))
        showControl();
}

void DriveDesk::endControl() {
    if (requests_.giveBack())
        showControl();
}

/// Enables the drive keys while the user has control; releases the pad and stops repeating when control has ended.
void DriveDesk::showControl() {
    keys_.setActive(taken());
    if (!taken()) {
        views_.drive->letGo();
        beat_.stop();
    }
    commands_.refresh();
}

void DriveDesk::requestControl(bool take) {
    if (take && live()) {
        for (const HandSource source : mission::HandRequests::sources)
            say(source); // a device that is held already has to be released first
        robot()->takeControl();
        beginControl();
        gamepad_.start();
        emit realTimeWanted();
    } else if (robot()) {
        robot()->giveControlBack();
        endControl();
    }
    show();
}

void DriveDesk::ask(mission::HandSource source, const Stick& stick) {
    if (requests_.move(source, stick))
        say(source);
    if (taken() && requests_.isHeld(source) && !beat_.isActive())
        beat_.start();
}

void DriveDesk::say(mission::HandSource source) {
    if (robot())
        robot()->drive(requests_.intentOf(source, gamepad_.name().toStdString(), speedShare()));
}

void DriveDesk::repeat() {
    const std::vector<HandSource> held = requests_.held();
    for (const HandSource source : held)
        say(source);
    if (held.empty())
        beat_.stop();
}

void DriveDesk::letGo(const QString& reason) {
    if (taken() && robot())
        robot()->stopDriving(reason);
    views_.drive->letGo();
}

/// Ends both a running behavior and driving by hand.
void DriveDesk::stopRobot() {
    if (!robot() || robot()->isReplay())
        return;
    views_.drive->letGo();
    robot()->stop();
    endControl();
    show();
}

void DriveDesk::wireGamepad() {
    connect(&gamepad_, &Gamepad::moved, this, [this](const Stick& stick) { ask(HandSource::Gamepad, stick); });
    connect(&gamepad_, &Gamepad::unplugged, this, [this](const QString& name) {
        if (requests_.isHeld(HandSource::Gamepad))
            letGo(tr("the gamepad %1 was unplugged").arg(name));
        ask(HandSource::Gamepad, {});
        showGamepad();
    });
    connect(&gamepad_, &Gamepad::plugged, this, &DriveDesk::showGamepad);
    connect(&gamepad_, &Gamepad::stopPressed, this, [this] { letGo(tr("the gamepad's stop button was pressed")); });
    connect(&gamepad_, &Gamepad::takePressed, this, [this] { requestControl(!taken()); });
    showGamepad();
}

void DriveDesk::showGamepad() {
    if (!Gamepad::supported())
        return views_.drive->setGamepad(tr("Gamepad: this program was built without SDL 2."));
    views_.drive->setGamepad(gamepad_.name().isEmpty() ? tr("Gamepad: none plugged in")
                                                       : tr("Gamepad: %1").arg(gamepad_.name()));
}

void DriveDesk::take(int id, const mission::SessionUpdate& update) {
    if (id != selected_)
        return;
    if (requests_.hear(update.figures.control.reins, wall()))
        showControl();
    velocity_.take(update);
    for (const mission::SentCommand& command : update.commands)
        if (mission::isHandCause(command.cause.source) && protocol::isDrive(command.command))
            views_.drive->setEcho(QString::fromStdString(command.text));
    const auto twist = velocity_.twist();
    widgets::BodyVelocity shown;
    if (twist) {
        shown = {twist->velocity_m_s.x(), twist->velocity_m_s.y(), {}, twist->yaw_rate_rad_s};
        if (!twist->planar)
            shown.up_m_s = twist->velocity_m_s.z();
    }
    views_.drive->setVelocity(shown, !live());
    show();
}

void DriveDesk::refresh() {
    if (!live())
        endControl();
    show();
}

QString DriveDesk::noteFor(const mission::ControlState& state) const {
    if (!taken())
        return state.reins == Reins::Behavior ? tr("Taking control pauses the behavior.") : QString();
    if (!state.hindrance.empty())
        return QString::fromStdString(state.hindrance);
    if (state.learning)
        return tr("Asking the server how it is driven…");
    if (!state.held && !state.last_stop.empty())
        return tr("Stopped: %1.").arg(QString::fromStdString(state.last_stop));
    return state.held ? QString() : tr("Hold a key, the pad or a gamepad's stick. Space stops, Shift drives slower.");
}

bool DriveDesk::showWhatIsMissing() {
    widgets::DrivePanel& panel = *views_.drive;
    const Robot* const here = robot();
    if (!here)
        panel.setEmpty(tr("No robot yet"), tr("Double-click a start pose on the map; then drive it from here."));
    else if (here->isReplay())
        panel.setEmpty(tr("A recording cannot be driven"), tr("What it shows has happened already."));
    else if (protocol::isStation(here->view().spawn.class_name))
        panel.setEmpty(tr("%1 does not move").arg(nameOf(*here)), tr("It is a base station."));
    else if (here->view().link.state != link::LinkState::Connected)
        panel.setEmpty(tr("No link to %1").arg(nameOf(*here)),
                       tr("The server takes a robot away with its connection. Spawn it again when connected."));
    else if (!here->view().figures.spawned)
        panel.setEmpty(tr("%1 is not there").arg(nameOf(*here)), tr("It can be driven once it is spawned."));
    else
        return panel.setEmpty({}, {}), false;
    return true;
}

void DriveDesk::show() {
    const Robot* const here = robot();
    const bool missing = showWhatIsMissing();
    widgets::DriveState shown;
    shown.control = controlWords(control_, here);
    views_.driver->setWords(shown.control);
    if (here && !here->isReplay() && !protocol::isStation(here->view().spawn.class_name))
        shown.robot = nameOf(*here);
    if (!missing) {
        const mission::ControlState& state = here->view().figures.control;
        shown.can_take = true;
        shown.taken = taken();
        shown.axes = state.axes;
        shown.asked = state.asked;
        shown.sent = state.sent;
        shown.top_speed_m_s = state.top_speed_m_s;
        shown.note = noteFor(state);
        shown.note_is_trouble = !state.hindrance.empty() || (!state.held && !state.last_stop.empty());
    }
    keys_.setAxes(shown.axes);
    if (!(shown == views_.drive->state()))
        views_.drive->setState(shown);
    if (commands_.contains("drive.take"))
        commands_.action("drive.take")->setChecked(taken());
}

} // namespace usar::app
