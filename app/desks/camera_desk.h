// Desk of the camera dock: shows the pictures of the selected robot's camera, zooms and turns it, and switches the
// headlight.
#pragma once

#include <optional>

#include <QImage>

#include "app/desks/desk.h"
#include "core/mission/fleet/camera_feed.h"
#include "core/mission/hand/camera_mount.h"
#include "core/mission/hand/camera_work.h"
#include "core/protocol/usual_values.h"

namespace usar::app {

/// Requests pictures only while the view is visible and the selected robot may have a camera. Asks the server which
/// cameras the robot has; pictures come from the image server of the connected server. GUI thread.
class CameraDesk : public Desk {
    Q_OBJECT
public:
    explicit CameraDesk(const DeskContext& context);

    void registerCommands() override;
    void wire() override;
    void restore(const QSettings& settings) override;
    void save(SettingsSheet& settings) const override;
    /// Saves as PNG or JPEG, by the suffix of `path`; the result is a notice.
    void savePicture(const QImage& picture, const QString& path);

private:
    void wireView();
    void wireFeed();
    /// True if there is a picture and the chosen camera can zoom.
    bool canZoom() const { return !view_.isEmpty() && work_.mount().canZoom(); }
    /// True if there is a picture of a live robot and the mount of its camera can turn.
    bool canTurn() const { return live() && !view_.isEmpty() && work_.mount().canTurn(); }
    /// True if the selected robot has a camera; nullopt while that is unknown.
    std::optional<bool> hasCamera() const;
    /// Starts over, because another robot was selected.
    void select();
    void take(const mission::SessionUpdate& update);
    /// Updates the view and the connection to the image server after any change that may affect them.
    void refresh();
    /// Sends AttachCamera for the chosen camera.
    void attach();
    /// Shows the names of the cameras, and the zoom of the chosen one.
    void showCamera();
    /// Enables and checks the commands according to what the camera can do.
    void showAbilities();
    /// Returns true if there can be no picture; the view then says why, and what the user can do.
    bool showWhatIsMissing();
    void chooseImagePort();

    widgets::CameraView& view_;
    mission::CameraFeed feed_;
    link::ImageStatus feed_status_;
    mission::CameraWork work_;
    quint16 embedded_port_ = 0; ///< port of the embedded simulator's image server; 0: there is none
    /// Port of a real server's image server, which is on the same host as its bot port.
    quint16 server_port_ = protocol::usual_port::image;
    bool was_live_ = false; ///< result of `live` at the last refresh
};

} // namespace usar::app
