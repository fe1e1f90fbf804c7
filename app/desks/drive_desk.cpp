#include "app/desks/drive_desk.h"

#include <algorithm>

#include "app/desks/robot_presenter.h"
#include "core/mission/fleet/robot_words.h"
#include "core/mission/hand/control_state.h"
#include "core/protocol/commands/spawn.h"

namespace usar::app {

namespace {

using mission::HandSource;
using mission::Reins;

constexpr int beat_ms = 50;
constexpr double speed_step = 0.1;

} // namespace

DriveDesk::DriveDesk(const DeskContext& context) : Desk(context), keys_(context.window) {
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
    connect(&gamepad_, &widgets::Gamepad::moved, this, [this](const Stick& stick) { ask(HandSource::Gamepad, stick); });
    connect(&gamepad_, &widgets::Gamepad::unplugged, this, [this](const QString& name) {
        if (requests_.isHeld(HandSource::Gamepad))
            letGo(tr("the gamepad %1 was unplugged").arg(name));
        ask(HandSource::Gamepad, {});
        showGamepad();
    });
    connect(&gamepad_, &widgets::Gamepad::plugged, this, &DriveDesk::showGamepad);
    connect(&gamepad_, &widgets::Gamepad::stopPressed, this,
            [this] { letGo(tr("the gamepad's stop button was pressed")); });
    connect(&gamepad_, &widgets::Gamepad::takePressed, this, [this] { requestControl(!taken()); });
    showGamepad();
}

void DriveDesk::registerCommands() {
    const auto drives = [this] { return taken(); };
    add(
        "drive.take", [this] { return drivable(); }, [this](bool on) { requestControl(on); });
    add("drive.stop", drives, [this] { letGo(tr("the user stopped it")); });
    add("drive.faster", drives, [this] { setSpeedShare(views_.drive->speedShare() + speed_step); });
    add("drive.slower", drives, [this] { setSpeedShare(views_.drive->speedShare() - speed_step); });
    show();
}

void DriveDesk::wire() {
    connect(&selection_, &Selection::changed, this, &DriveDesk::select);
    connectUpdates([this](const mission::SessionUpdate& update) { take(update); });
    connect(&control_, &MissionControl::robotLinkChanged, this, &DriveDesk::refresh);
    connect(&gamepad_, &widgets::Gamepad::plugged, this,
            [this](const QString& name) { notices_.note("gamepad", tr("The gamepad %1 is plugged in.").arg(name)); });
}

bool DriveDesk::drivable() const {
    return mission::whyNotDriven(robot() ? &robot()->view() : nullptr).title.isEmpty();
}

void DriveDesk::setSpeedShare(double share) {
    views_.drive->setSpeedShare(std::clamp(share, 0.05, 1.0));
}

void DriveDesk::select(RobotId id) {
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
    emit drivingChanged(taken());
    commands_.refresh();
}

void DriveDesk::requestControl(bool take) {
    if (take && drivable()) {
        for (const HandSource source : mission::HandRequests::sources)
            say(source); // a device that is held already has to be released first
        robot()->takeControl();
        if (requests_.take(wall()))
            showControl();
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
        robot()->drive(requests_.intentOf(source, gamepad_.name().toStdString(), views_.drive->speedShare()));
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

void DriveDesk::showGamepad() {
    if (!widgets::Gamepad::supported())
        return views_.drive->setGamepad(tr("Gamepad: this program was built without SDL 2."));
    views_.drive->setGamepad(gamepad_.name().isEmpty() ? tr("Gamepad: none plugged in")
                                                       : tr("Gamepad: %1").arg(gamepad_.name()));
}

void DriveDesk::take(const mission::SessionUpdate& update) {
    if (requests_.hear(update.figures.control.reins, wall()))
        showControl();
    velocity_.take(update);
    for (const mission::SentCommand& command : update.commands)
        if (std::holds_alternative<by::Hand>(command.cause.source) && protocol::isDrive(command.command))
            views_.drive->setEcho(QString::fromStdString(command.text));
    widgets::BodyVelocity shown;
    if (const auto twist = velocity_.twist()) {
        shown = {twist->velocity_m_s.x(), twist->velocity_m_s.y(), {}, twist->yaw_rate_rad_s};
        if (!twist->planar)
            shown.up_m_s = twist->velocity_m_s.z();
    }
    views_.drive->setVelocity(shown, !drivable());
    show();
}

void DriveDesk::refresh() {
    if (!drivable())
        endControl();
    show();
}

void DriveDesk::show() {
    const RobotView* const view = robot() ? &robot()->view() : nullptr;
    const auto [missing, hint] = mission::whyNotDriven(view);
    views_.drive->setEmpty(missing, hint);
    widgets::DriveState shown;
    shown.control = controlWords(control_, robot());
    views_.driver->setWords(shown.control);
    if (view && view->recording.isEmpty() && !protocol::isStation(view->spawn.class_name))
        shown.robot = nameOf(*robot());
    if (missing.isEmpty()) {
        const mission::ControlState& state = view->figures.control;
        shown.can_take = true;
        shown.taken = taken();
        shown.axes = state.axes;
        shown.asked = state.asked;
        shown.sent = state.sent;
        shown.top_speed_m_s = state.top_speed_m_s;
        shown.note = mission::driveNote(state, taken());
        shown.note_is_trouble = !state.hindrance.empty() || (!state.held && !state.last_stop.empty());
    }
    keys_.setAxes(shown.axes);
    if (!(shown == views_.drive->state()))
        views_.drive->setState(shown);
    if (commands_.contains("drive.take"))
        action("drive.take")->setChecked(taken());
}

} // namespace usar::app
