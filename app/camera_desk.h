// Brings the selected robot's camera to the camera view: asks which cameras it has, where pictures come from, and sends
// what zooms and turns them.
#pragma once

#include <deque>
#include <map>
#include <optional>
#include <vector>

#include <QObject>
#include <QTimer>

#include "app/camera_feed.h"
#include "app/mission_control.h"
#include "core/protocol/info/configurations.h"
#include "widgets/camera_view.h"

namespace usar::app {

/// GUI thread. Asks for pictures only while the view is visible and there is a camera to be seen. Servers take one SET
/// a tick, so these go one after the other, and only the newest of a kind.
class CameraDesk : public QObject {
    Q_OBJECT
public:
    CameraDesk(MissionControl& control, widgets::CameraView& view);

    void select(int id);
    /// Of the selected robot.
    void take(const mission::SessionUpdate& update);
    /// The embedded simulator's image server listens there; 0: there is none.
    void setEmbeddedPort(quint16 port);
    /// Classes of the embedded simulator that have a camera.
    void setCameraClasses(const QStringList& classes);
    quint16 serverPort() const { return server_port_; }
    /// Of a real server, on the same host as its bot port.
    void setServerPort(quint16 port);
    /// What opens the dialog for that port; the view's empty state offers it.
    void setPortAction(QAction* action) { port_action_ = action; }

    bool canZoom() const;
    bool canTurn() const;
    bool canLight() const;
    bool lightOn() const { return light_on_; }
    void zoomBy(double factor);
    void resetZoom();
    /// In parts of the angle of view.
    void turnBy(double right, double up);
    void center();
    void setLight(bool on);
    /// Does the view show what it should? Called where something may have changed.
    void refresh();

signals:
    /// What can be done with the camera has changed.
    void changed();

private:
    struct Camera {
        protocol::CameraConfiguration configuration;
        double fov_rad = 1.396;
    };
    struct Package {
        std::string name;
        std::map<int, double> wanted; ///< by link
    };

    const Robot* robot() const { return control_.robot(selected_); }
    bool live() const;
    /// Nothing where it is not known whether the robot has one.
    std::optional<bool> hasCamera() const;
    void ask();
    void takeMessage(const protocol::InfoMessage& message);
    void takeCameras(const std::vector<protocol::CameraConfiguration>& cameras);
    void showCamera();
    void showEmpty(const QString& title, const QString& hint, QAction* action = nullptr);
    bool showWhatIsMissing();
    QString camerasHere() const;
    void attach();
    void requestZoom(double fov_rad);
    void turn(double right_rad, double up_rad);
    void sendTurn();
    void sendSet();
    void queueSet(const protocol::Command& command);

    MissionControl& control_;
    widgets::CameraView& view_;
    CameraFeed feed_;
    link::ImageStatus feed_status_;
    QAction* port_action_ = nullptr;
    quint16 embedded_port_ = 0;
    quint16 server_port_ = 5003;
    QStringList camera_classes_;
    int selected_ = 0;
    int questions_ = 0;
    QTimer answer_timer_;
    bool answered_ = false;
    std::vector<Camera> cameras_;
    std::size_t shown_ = 0;
    std::optional<Package> package_;
    QTimer turn_timer_;
    std::deque<protocol::Command> sets_;
    QTimer set_timer_; ///< runs while a SET waits for its answer
    QString attached_; ///< robot, camera and address
    bool was_live_ = false;
    bool light_on_ = false;
    bool lamp_known_ = false;
};

} // namespace usar::app
