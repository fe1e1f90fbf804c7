// The camera dock: asks which cameras the selected robot has, where pictures come from, and sends what zooms and turns
// them.
#pragma once

#include <optional>

#include <QImage>
#include <QObject>
#include <QTimer>

#include "app/desks/desk.h"
#include "core/mission/fleet/camera_feed.h"
#include "core/mission/session/camera_mount.h"
#include "core/protocol/usual_values.h"

namespace usar::app {

/// Asks for pictures only while the view is visible and there is a camera to be seen. GUI thread.
class CameraDesk : public QObject {
    Q_OBJECT
public:
    explicit CameraDesk(const DeskContext& context);

    void registerCommands();
    /// Once commands are registered.
    void wire();
    void savePicture(const QImage& picture, const QString& path);

private:
    void registerTurnCommands();
    void wireView();
    void wireFeed();
    const Robot* robot() const { return desk_.selection.robot(); }
    bool live() const;
    bool canZoom() const;
    bool canTurn() const;
    /// Absent while it is not known whether the robot has one.
    std::optional<bool> hasCamera() const;
    void select();
    void take(const mission::SessionUpdate& update);
    /// Shows what the view should show; called when something may have changed.
    void refresh();
    void ask();
    void attach();
    void showCamera();
    void showAbilities();
    bool showWhatIsMissing();
    QString camerasHere() const;
    void turn(double right_rad, double up_rad);
    void turnSoon();
    void sendTurn();
    void queueSet(const protocol::Command& set);
    void sendSet();
    void sendSetSoon();
    void chooseImagePort();
    void chooseWhereToSave();

    DeskContext desk_;
    widgets::CameraView& view_;
    mission::CameraFeed feed_;
    link::ImageStatus feed_status_;
    mission::CameraMount mount_;
    quint16 embedded_port_ = 0; ///< of the embedded simulator's image server; 0: there is none
    quint16 server_port_ =
        protocol::usual_port::image; ///< of a real server's image server, on the same host as its bot port
    int questions_ = 0;
    QTimer answer_timer_;
    QTimer turn_timer_;
    QTimer set_timer_; ///< runs while a SET waits for its answer
    QString attached_; ///< robot, camera and address
    bool was_live_ = false;
};

} // namespace usar::app
