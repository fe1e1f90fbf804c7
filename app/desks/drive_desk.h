// Lets the user drive the selected robot by hand: with keys, the pad in the dock, or a gamepad.
#pragma once

#include <QElapsedTimer>
#include <QTimer>

#include "app/desks/desk.h"
#include "core/mission/fleet/velocity_watch.h"
#include "core/mission/hand/hand_requests.h"
#include "widgets/drive/drive_keys.h"
#include "widgets/drive/gamepad.h"

namespace usar::app {

/// The robot's session decides who drives (hand_control.h). This desk only sends it what each input device requests, at
/// once and then twenty times a second while the device is deflected. All devices count as released if the focus is
/// lost, another robot is selected, the gamepad is unplugged or the window closes. Belongs to the GUI thread.
class DriveDesk : public Desk {
    Q_OBJECT
public:
    explicit DriveDesk(const DeskContext& context);

    void registerCommands() override;
    void wire() override;
    /// Releases all devices and gives control back.
    void leave();

    /// True if the user has requested control of the selected robot or has it.
    bool taken() const { return requests_.taken(); }
    /// `share`: 0..1 of the robot's top speed.
    void setSpeedShare(double share);
    widgets::Gamepad& gamepad() { return gamepad_; }

signals:
    /// Simulated time should run in real time, because nobody can drive by hand at another pace.
    void realTimeWanted();
    /// The user drives from now on, or no longer does; while driving, the drive keys belong to the robot.
    void drivingChanged(bool drives);

private:
    /// Gives control of the old robot back, and empties echo and velocity until the new one reports.
    void select(RobotId id);
    /// Shows what the robot does, and the DRIVE commands that were sent by hand.
    void take(const mission::SessionUpdate& update);
    /// Ends control if the robot can no longer be driven, for example because its link is lost.
    void refresh();
    /// The robot that the devices drive; still the old one while another one is being selected.
    Robot* robot() const { return control_.robot(selected_); }
    /// True if the robot can be driven by hand now.
    bool drivable() const;
    /// Forgets that the user has control; sends nothing to the robot.
    void endControl();
    /// Enables the drive keys while the user has control; otherwise releases the pad and stops repeating.
    void showControl();
    /// Wall time since the desk was made.
    Seconds wall() const { return Seconds(static_cast<double>(clock_.elapsed()) / 1000.0); }
    /// Takes control of the selected robot if it can be driven, or gives it back.
    void requestControl(bool take);
    /// Notes how far a device is deflected and sends it at once; repeats it while the user has control.
    void ask(mission::HandSource source, const Stick& stick);
    /// Sends the requests of all deflected devices again; stops the timer when there are none.
    void repeat();
    /// Sends the newest request of one device, scaled by the speed share.
    void say(mission::HandSource source);
    /// Stops driving and releases the pad. `reason` is a clause for the user: "Space was pressed".
    void letGo(const QString& reason);
    /// Ends both a running behavior and driving by hand; has no effect on a replay.
    void stopRobot();
    /// Names the gamepad, or says that there is none or that the program was built without SDL 2.
    void showGamepad();
    void show();

    widgets::DriveKeys keys_;
    widgets::Gamepad gamepad_;
    QTimer beat_; ///< repeats the requests of deflected devices
    mission::HandRequests requests_;
    mission::VelocityWatch velocity_;
    QElapsedTimer clock_; ///< wall time
    RobotId selected_;    ///< the selected robot
};

} // namespace usar::app
