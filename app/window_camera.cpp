// The camera dock's commands, and its wires.
#include <QFileDialog>
#include <QInputDialog>
#include <QSettings>

#include "app/main_window.h"

namespace usar::app {

namespace {

constexpr double zoom_step = 1.25;
constexpr double turn_step = 0.125; ///< of the angle of view

} // namespace

void MainWindow::registerCameraCommands() {
    const QString group = tr("Camera");
    const auto zooms = [this] { return camera_->canZoom(); };
    const auto turns = [this] { return camera_->canTurn(); };
    const auto turn = [this](double right, double up) {
        return [this, right, up](bool) { camera_->turnBy(right * turn_step, up * turn_step); };
    };
    commands_.add(
        {"camera.zoom_in",
         tr("Zoom camera in"),
         group,
         tr("A narrower angle of view"),
         "plus",
         {QKeySequence("Alt++"), QKeySequence("Alt+=")}},
        [this](bool) { camera_->zoomBy(zoom_step); }, zooms);
    commands_.add(
        {"camera.zoom_out",
         tr("Zoom camera out"),
         group,
         tr("A wider angle of view"),
         "minus",
         {QKeySequence("Alt+-")}},
        [this](bool) { camera_->zoomBy(1.0 / zoom_step); }, zooms);
    commands_.add(
        {"camera.zoom_default",
         tr("Camera's own angle of view"),
         group,
         tr("As it was when it was spawned"),
         "",
         {QKeySequence("Alt+0")}},
        [this](bool) { camera_->resetZoom(); }, zooms);
    commands_.add({"camera.left", tr("Turn camera left"), group, tr("Pans it"), "", {QKeySequence("Alt+Shift+Left")}},
                  turn(-1.0, 0.0), turns);
    commands_.add(
        {"camera.right", tr("Turn camera right"), group, tr("Pans it"), "", {QKeySequence("Alt+Shift+Right")}},
        turn(1.0, 0.0), turns);
    commands_.add({"camera.up", tr("Turn camera up"), group, tr("Tilts it"), "", {QKeySequence("Alt+Shift+Up")}},
                  turn(0.0, 1.0), turns);
    commands_.add({"camera.down", tr("Turn camera down"), group, tr("Tilts it"), "", {QKeySequence("Alt+Shift+Down")}},
                  turn(0.0, -1.0), turns);
    commands_.add(
        {"camera.center",
         tr("Look straight ahead"),
         group,
         tr("Pan and tilt back to zero"),
         "follow",
         {QKeySequence("Alt+Shift+Home")}},
        [this](bool) { camera_->center(); }, turns);
    commands_.add(
        {"camera.light",
         tr("Headlight"),
         group,
         tr("Switches the robot's headlight"),
         "sun",
         {QKeySequence("Alt+Shift+L")},
         true},
        [this](bool on) { camera_->setLight(on); }, [this] { return camera_->canLight(); });
    commands_.add(
        {"camera.save",
         tr("Save picture…"),
         group,
         tr("What the camera shows now, as a file"),
         "export",
         {QKeySequence("Alt+Shift+S")}},
        [this](bool) { chooseWhereToSavePicture(); }, [this] { return !views_.camera->isEmpty(); });
    commands_.add({"camera.port",
                   tr("Image server's port…"),
                   group,
                   tr("Where a real server's pictures come from; usually 5003"),
                   "",
                   {}},
                  [this](bool) { chooseImagePort(); });
    camera_->setPortAction(commands_.action("camera.port"));
    QList<QAction*> shown;
    for (const char* const id : {"camera.center", "camera.light", "camera.save"})
        shown << commands_.action(id);
    views_.camera->setActions(shown);
}

void MainWindow::wireCamera() {
    camera_->setServerPort(static_cast<quint16>(QSettings().value("server/image_port", 5003).toUInt()));
    connect(&control_.simulator(), &SimulatorHost::channelsOpened, this,
            [this](const ChannelPorts& ports) { camera_->setEmbeddedPort(ports.image); });
    connect(&control_, &MissionControl::worldKnown, this,
            [this](const WorldPicture& world) { camera_->setCameraClasses(world.camera_classes); });
    connect(&control_, &MissionControl::robotUpdated, this, [this](int id, const auto& update) {
        if (id == selected_)
            camera_->take(*update);
    });
    connect(&control_, &MissionControl::robotLinkChanged, camera_.get(), &CameraDesk::refresh);
    connect(camera_.get(), &CameraDesk::changed, this, [this] {
        commands_.action("camera.light")->setChecked(camera_->lightOn());
        commands_.refresh();
    });
}

void MainWindow::chooseImagePort() {
    bool chosen = false;
    const int port = QInputDialog::getInt(this, tr("Image server"), tr("Port of the image server, beside the bot port"),
                                          camera_->serverPort(), 1, 65535, 1, &chosen);
    if (!chosen)
        return;
    QSettings().setValue("server/image_port", port);
    camera_->setServerPort(static_cast<quint16>(port));
}

void MainWindow::chooseWhereToSavePicture() {
    const QImage picture = views_.camera->picture(); // as it is now, not when the dialog closes
    const QString path =
        QFileDialog::getSaveFileName(this, tr("Save picture"), tr("camera.png"), tr("Pictures (*.png *.jpg)"));
    if (!path.isEmpty())
        savePicture(picture, QFileInfo(path).suffix().isEmpty() ? path + ".png" : path);
}

void MainWindow::savePicture(const QImage& picture, const QString& path) {
    if (!picture.save(path))
        return say(Severity::Error, "picture",
                   tr("The picture could not be saved as %1. Choose a folder that can be written to, and .png or .jpg.")
                       .arg(path));
    views_.notifications->push("picture", Severity::Note, tr("Saved the picture %1.").arg(path), true);
}

} // namespace usar::app
