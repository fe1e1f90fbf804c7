// Works the camera of one robot at a time: asks which cameras there are, zooms, turns, and chooses the one to watch.
#pragma once

#include <functional>

#include <QObject>
#include <QString>
#include <QTimer>

#include "core/mission/hand/camera_mount.h"

namespace usar::mission {

/// Sends the commands of a CameraMount at the pace that servers take them: one SET until the server has answered it, or
/// for half a second (UDK servers do not answer), and turns at most every 100 ms. Angles are radians. Belongs to one
/// thread, that of its owner.
class CameraWork : public QObject {
    Q_OBJECT
public:
    using Send = std::function<void(const protocol::Command& command)>;

    /// `live`: true while the robot can take commands. Both functions are called directly.
    CameraWork(std::function<bool()> live, Send send);

    const CameraMount& mount() const { return mount_; }
    /// Forgets everything, because another robot is worked from now on.
    void restart();
    void take(const protocol::InfoMessage& message);
    /// Asks which cameras the robot has, at most three times and every 2.5 s; does nothing once that is known. Of two
    /// questions a server answers only the newest, so do not call it while a behavior asks its own.
    void ask();
    /// Tells the server which camera this viewer wants to see; otherwise several cameras are shown as a mosaic.
    /// `address`: that of the connection to the image server; empty: there is none. The same request is not repeated.
    void attach(const QString& robot, const QString& address);
    /// The connection to the image server has ended or changed; the next `attach` is sent in any case.
    void detach() { attached_.clear(); }
    /// Chooses the camera that is shown.
    void show(const QString& camera) { mount_.show(camera.toStdString()); }
    void zoomTo(double fov_rad);
    void zoomBy(double factor);
    void resetZoom();
    void turn(double right_rad, double up_rad) { turnSoon(mount_.turn(right_rad, up_rad)); }
    /// Turns by fractions of the camera's angle of view.
    void turnBy(double right, double up) { turnSoon(mount_.turnBy(right, up)); }
    void center();

signals:
    /// The cameras or the angle of view have changed.
    void pictureChanged();
    /// It is known now which cameras there are; there may be none.
    void camerasKnown();
    /// Emitted when the set of things that can be turned or lit has changed.
    void abilitiesChanged();
    /// A question was not answered in time; `ask` repeats it.
    void unanswered();

private:
    void sendZoom();
    void turnSoon(bool turned);
    void sendTurn();
    /// Sends the next waiting SET.
    void sendSet();
    /// Does so at once, or when the previous SET was answered.
    void sendSetSoon();

    std::function<bool()> live_;
    Send send_;
    CameraMount mount_;
    int questions_ = 0;   ///< number of times that this robot was asked for its cameras
    QTimer answer_timer_; ///< runs while that question waits for its answer
    QTimer turn_timer_;   ///< runs until the wanted direction is sent
    QTimer set_timer_;    ///< runs while a SET waits for its answer
    QString attached_;    ///< robot, camera and address of the last AttachCamera; empty: none
};

} // namespace usar::mission
