// Brings the person's hands to the selected robot: keys, the pad in the dock, a gamepad.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include "app/desks/desk.h"
#include "app/host/gamepad.h"
#include "core/mission/hand/hand_requests.h"
#include "core/mission/session/velocity_watch.h"
#include "widgets/drive/drive_keys.h"

namespace usar::app {

/// GUI thread. The rules of who drives live in the robot's session (hand_control.h): here is only said what each hand
/// asks, at once and then twenty times a second while it asks for anything. A lost focus, another selected robot, an
/// unplugged gamepad and a closing window let everything go.
class DriveDesk : public QObject {
    Q_OBJECT
public:
    explicit DriveDesk(const DeskContext& context);

    void registerCommands();
    /// Once commands are registered.
    void wire();
    /// Everything is let go and control is given back.
    void leave();

    /// The person has asked for control of the selected robot, or has it.
    bool taken() const { return requests_.taken(); }
    double speedShare() const;
    void setSpeedShare(double share);
    Gamepad& gamepad() { return gamepad_; }

signals:
    /// Nobody can drive faster than the clock on the wall.
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
    QTimer beat_;
    mission::HandRequests requests_;
    mission::VelocityWatch velocity_;
    QElapsedTimer clock_; ///< wall time
    int selected_ = 0;
};

} // namespace usar::app
