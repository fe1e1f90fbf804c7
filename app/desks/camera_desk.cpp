#include "app/desks/camera_desk.h"

#include "core/mission/fleet/robot_words.h"
#include "widgets/panels/dialogs.h"

namespace usar::app {

namespace {

constexpr double zoom_step = 1.25;
constexpr double turn_step = 0.125; ///< as a fraction of the angle of view
const by::Other cause{"camera"};

QString classOf(const Robot& robot) {
    return QString::fromStdString(robot.view().spawn.class_name).section('.', -1);
}

} // namespace

CameraDesk::CameraDesk(const DeskContext& context)
    : Desk(context)
    , view_(*context.views.camera)
    , work_([this] { return live(); }, [this](const protocol::Command& command) { robot()->send(command, cause); }) {}

void CameraDesk::registerCommands() {
    const auto zooms = [this] { return canZoom(); };
    add("camera.zoom_in", zooms, [this] { work_.zoomBy(zoom_step); });
    add("camera.zoom_out", zooms, [this] { work_.zoomBy(1.0 / zoom_step); });
    add("camera.zoom_default", zooms, [this] { work_.resetZoom(); });
    const auto turns = [this] { return canTurn(); };
    add("camera.left", turns, [this] { work_.turnBy(-turn_step, 0.0); });
    add("camera.right", turns, [this] { work_.turnBy(turn_step, 0.0); });
    add("camera.up", turns, [this] { work_.turnBy(0.0, turn_step); });
    add("camera.down", turns, [this] { work_.turnBy(0.0, -turn_step); });
    add("camera.center", turns, [this] { work_.center(); });
    const auto has_light = [this] { return live() && work_.mount().lightKnown(); };
    add("camera.light", has_light, [this](bool on) { robot()->send(protocol::DriveSwitches{.light_on = on}, cause); });
    const auto has_picture = [this] { return !view_.isEmpty(); };
    add("camera.save", has_picture, [this] {
        const QImage picture = view_.picture(); // The current one, not the one when the dialog closes.
        widgets::askWhereToSave(window_, tr("Save picture"), tr("camera.png"), tr("Pictures (*.png *.jpg)"),
                                [this, picture](const QString& path) { savePicture(picture, path); });
    });
    add("camera.overlay", [this](bool on) { view_.setOverlayShown(on); });
    add("camera.port", [this] { chooseImagePort(); });
}

void CameraDesk::wire() {
    view_.setActions({action("camera.center"), action("camera.light"), action("camera.save")});
    server_port_ = static_cast<quint16>(QSettings().value("server/image_port", server_port_).toUInt());
    connect(&control_.simulator(), &server::SimulatorHost::channelsOpened, this,
            [this](const server::ChannelPorts& ports) {
                embedded_port_ = ports.image;
                refresh();
            });
    connect(&control_, &MissionControl::classesChanged, this, &CameraDesk::refresh);
    connect(&control_, &MissionControl::robotLinkChanged, this, &CameraDesk::refresh);
    connectUpdates([this](const mission::SessionUpdate& update) { take(update); });
    connect(&selection_, &Selection::changed, this, &CameraDesk::select);
    wireView();
    wireFeed();
}

void CameraDesk::restore(const QSettings& settings) {
    const bool shown = settings.value("camera/overlay", true).toBool();
    action("camera.overlay")->setChecked(shown);
    view_.setOverlayShown(shown);
}

void CameraDesk::save(SettingsSheet& settings) const {
    settings.setValue("camera/overlay", action("camera.overlay")->isChecked());
}

void CameraDesk::wireView() {
    connect(&view_, &widgets::CameraView::wantsPicturesChanged, this, &CameraDesk::refresh);
    connect(&view_, &widgets::CameraView::zoomRequested, this, [this](double fov_rad) {
        if (canZoom())
            work_.zoomTo(fov_rad);
    });
    connect(&view_, &widgets::CameraView::turnRequested, this, [this](double right_rad, double up_rad) {
        if (canTurn())
            work_.turn(right_rad, up_rad);
    });
    connect(&view_, &widgets::CameraView::cameraChosen, this, [this](const QString& name) {
        work_.show(name);
        showCamera();
        attach();
    });
    connect(&work_, &mission::CameraWork::pictureChanged, this, &CameraDesk::showCamera);
    connect(&work_, &mission::CameraWork::camerasKnown, this, &CameraDesk::refresh);
    connect(&work_, &mission::CameraWork::abilitiesChanged, this, &CameraDesk::showAbilities);
    connect(&work_, &mission::CameraWork::unanswered, this, &CameraDesk::refresh);
}

void CameraDesk::wireFeed() {
    connect(&feed_, &mission::CameraFeed::statusChanged, this, [this](const link::ImageStatus& status) {
        const bool moved = status.state != feed_status_.state || status.reason != feed_status_.reason;
        if (status.local_address != feed_status_.local_address)
            work_.detach();
        feed_status_ = status;
        if (moved)
            refresh();
    });
    connect(&feed_, &mission::CameraFeed::unreadable, this,
            [this](const QString& reason) { view_.setEmpty(tr("No picture"), reason, action("camera.port")); });
    connect(&feed_, &mission::CameraFeed::pictureArrived, this, [this](const QImage& picture, double frames_per_s) {
        if (!live() || !view_.wantsPictures() || !hasCamera().value_or(true))
            return; // It belongs to the robot that was selected before.
        const bool first = view_.isEmpty();
        view_.setPicture(picture, frames_per_s);
        if (first)
            showAbilities();
    });
}

std::optional<bool> CameraDesk::hasCamera() const {
    const QStringList& classes = control_.world().camera_classes;
    if (!work_.mount().cameras().empty())
        return true;
    if (robot() && control_.server().embedded && !classes.isEmpty())
        return classes.contains(classOf(*robot()), Qt::CaseInsensitive);
    return work_.mount().answered() ? std::optional(false) : std::nullopt;
}

void CameraDesk::select() {
    work_.restart();
    feed_.setWanted(false);
    view_.setEmpty(tr("Waiting for the first picture"), {});
    showCamera();
    refresh();
}

void CameraDesk::refresh() {
    was_live_ = live();
    const bool missing = showWhatIsMissing();
    feed_.setWanted(!missing && view_.wantsPictures());
    if (!missing && view_.wantsPictures()) {
        const ServerTarget& server = control_.server();
        if (server.embedded)
            feed_.open("127.0.0.1", embedded_port_);
        else
            feed_.open(server.host, server_port_);
        if (!robot()->running()) // A behavior's own questions are more important.
            work_.ask();
        attach();
    }
    showAbilities();
}

void CameraDesk::showAbilities() {
    action("camera.light")->setChecked(work_.mount().lightOn());
    commands_.refresh();
}

/// Returns true if there can be no picture; the view then says why, and what the user can do.
bool CameraDesk::showWhatIsMissing() {
    const bool embedded = control_.server().embedded;
    const auto [missing, hint] = mission::whyNoPicture(
        robot() ? &robot()->view() : nullptr,
        {live(), hasCamera().value_or(true), !embedded || embedded_port_ != 0, control_.world().camera_classes});
    if (!missing.isEmpty())
        view_.setEmpty(missing, hint);
    else if (feed_status_.state == link::ImageState::Waiting && view_.wantsPictures())
        view_.setEmpty(tr("No image server"), feed_status_.reason, embedded ? nullptr : action("camera.port"));
    else if (view_.isEmpty())
        view_.setEmpty(tr("Waiting for the first picture"), {});
    return !missing.isEmpty();
}

void CameraDesk::take(const mission::SessionUpdate& update) {
    for (const protocol::InfoLine& line : update.lines)
        work_.take(line.message);
    if (live() != was_live_)
        refresh();
}

void CameraDesk::showCamera() {
    QStringList names;
    for (const mission::CameraMount::Camera& camera : work_.mount().cameras())
        names << QString::fromStdString(camera.configuration.name);
    const auto* const camera = work_.mount().shown();
    view_.setSource(robot() ? nameOf(*robot()) : QString(), names,
                    camera ? QString::fromStdString(camera->configuration.name) : QString());
    if (camera)
        view_.setZoom({camera->fov_rad, camera->configuration.smallest_fov_rad.value_or(camera->fov_rad),
                       camera->configuration.largest_fov_rad.value_or(camera->fov_rad)});
}

void CameraDesk::attach() {
    if (robot())
        work_.attach(nameOf(*robot()), feed_status_.local_address);
}

void CameraDesk::chooseImagePort() {
    widgets::askForNumber(window_, tr("Image server"), tr("Port of the image server, beside the bot port"),
                          server_port_, 1, 65535, [this](int port) {
                              QSettings().setValue("server/image_port", port);
                              server_port_ = static_cast<quint16>(port);
                              refresh();
                          });
}

void CameraDesk::savePicture(const QImage& picture, const QString& path) {
    if (!picture.save(path))
        return notices_.say(
            Severity::Error, "picture",
            tr("The picture could not be saved as %1. Choose a folder that can be written to, and .png or .jpg.")
                .arg(path));
    notices_.note("picture", tr("Saved the picture %1.").arg(path));
}

} // namespace usar::app
