// Desk for driving by hand: passes the input of keys, the pad in the dock and a gamepad to the selected robot.
#pragma once

#include <array>

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include "app/desks/desk.h"
#include "app/host/gamepad.h"
#include "core/mission/session/velocity_watch.h"
#include "widgets/drive/drive_keys.h"

namespace usar::app {

/// The robot's session decides who drives (hand_control.h). This desk only reports what each input device requests: on
/// each change, and twenty times a second while it requests any motion. Everything is released when the window loses
/// the focus or closes, another robot is selected, or the gamepad is unplugged. GUI thread.
class DriveDesk : public QObject {
    Q_OBJECT
public:
    explicit DriveDesk(const DeskContext& context);

    void registerCommands();
    /// To be called after all commands are registered.
    void wire();
    /// Releases everything and gives control back.
    void leave();

    /// True if the user has requested control of the selected robot, or has it.
    bool taken() const { return taken_; }
    /// Fraction of the robot's top speed at full stick, 0.05..1.
    double speedShare() const;
    void setSpeedShare(double share);
    Gamepad& gamepad() { return gamepad_; }

signals:
    /// Control was requested: simulated time should not run faster than real time, in which the user reacts.
    void realTimeWanted();

private:
    void select(int id);
    /// Takes an update of any robot; only that of the selected one is shown.
    void take(int id, const mission::SessionUpdate& update);
    void refresh();
    void openDock();
    /// The selected robot, or nullptr.
    Robot* robot() const { return control_.robot(selected_); }
    /// True if the selected robot can be driven: spawned, connected, no replay and no base station.
    bool live() const;
    void setTaken(bool taken);
    void requestControl(bool take);
    /// Stores the position of an input device and reports it.
    void ask(mission::HandSource source, const Stick& stick);
    /// Reports all devices that request motion.
    void repeat();
    /// Sends the position of one device to the robot's session.
    void say(mission::HandSource source);
    /// Stops the motion, but keeps control; `reason` is a part of a sentence.
    void letGo(const QString& reason);
    void stopRobot();
    void wireGamepad();
    void showGamepad();
    void show();
    /// Returns true if the selected robot cannot be driven; the panel then says why.
    bool showWhatIsMissing();
    /// The line of text below the pad; empty: none.
    QString noteFor(const mission::ControlState& state) const;

    MissionControl& control_;
    WindowViews& views_;
    widgets::CommandRegistry& commands_;
    Selection& selection_;
    NoticeDesk& notices_;
    widgets::DriveKeys keys_;
    Gamepad gamepad_;
    QTimer beat_;                ///< runs while a device requests motion
    std::array<Stick, 3> asked_; ///< positions, by HandSource
    mission::VelocityWatch velocity_;
    QElapsedTimer since_asked_; ///< since control was requested
    int selected_ = 0;
    bool taken_ = false;
    bool confirmed_ = false; ///< the session has confirmed that the user has control
};

} // namespace usar::app
