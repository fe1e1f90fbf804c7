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

private:
    void select(RobotId id);
    void take(const mission::SessionUpdate& update);
    void refresh();
    /// The robot that the devices drive; still the old one while another one is being selected.
    Robot* robot() const { return control_.robot(selected_); }
    /// True if the robot can be driven by hand now.
    bool drivable() const;
    void endControl();
    void showControl();
    Seconds wall() const { return Seconds(static_cast<double>(clock_.elapsed()) / 1000.0); }
    void requestControl(bool take);
    void ask(mission::HandSource source, const Stick& stick);
    void repeat();
    void say(mission::HandSource source);
    void letGo(const QString& reason);
    void stopRobot();
    void wireGamepad();
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
