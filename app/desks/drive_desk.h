// Lets the user drive the selected robot by hand: with keys, the pad in the dock, or a gamepad.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include "app/desks/desk.h"
#include "app/host/gamepad.h"
#include "core/mission/fleet/velocity_watch.h"
#include "core/mission/hand/hand_requests.h"
#include "widgets/drive/drive_keys.h"

namespace usar::app {

/// The robot's session decides who drives (hand_control.h). This desk only sends it what each input device requests, at
/// once and then twenty times a second while the device is deflected. All devices count as released if the focus is
/// lost, another robot is selected, the gamepad is unplugged or the window closes. Belongs to the GUI thread.
class DriveDesk : public QObject {
    Q_OBJECT
public:
    explicit DriveDesk(const DeskContext& context);

    void registerCommands();
    /// Connects signals; call it after all commands are registered.
    void wire();
    /// Releases all devices and gives control back.
    void leave();

    /// True if the user has requested control of the selected robot or has it.
    bool taken() const { return requests_.taken(); }
    double speedShare() const; ///< 0..1 of the robot's top speed
    void setSpeedShare(double share);
    Gamepad& gamepad() { return gamepad_; }

signals:
    /// Simulated time should run in real time, because nobody can drive by hand at another pace.
    void realTimeWanted();

private:
    void select(int id);
    /// An update of any robot; only the selected one's is shown.
    void take(int id, const mission::SessionUpdate& update);
    void refresh();
    void openDock();
    Robot* robot() const { return control_.robot(selected_); }
    bool live() const;
    void beginControl();
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
    bool showWhatIsMissing();
    QString noteFor(const mission::ControlState& state) const;

    MissionControl& control_;
    WindowViews& views_;
    widgets::CommandRegistry& commands_;
    Selection& selection_;
    NoticeDesk& notices_;
    widgets::DriveKeys keys_;
    Gamepad gamepad_;
    QTimer beat_; ///< repeats the requests of deflected devices
    mission::HandRequests requests_;
    mission::VelocityWatch velocity_;
    QElapsedTimer clock_; ///< wall time
    int selected_ = 0;    ///< id of the selected robot; 0: none
};

} // namespace usar::app
