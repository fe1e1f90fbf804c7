#include "app/desks/camera_desk.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QInputDialog>
#include <QSettings>

#include "core/mission/fleet/robot_name.h"

namespace usar::app {

namespace {

constexpr int most_questions = 3;
constexpr int answer_patience_ms = 2500;
constexpr int set_patience_ms = 500;
constexpr int turn_interval_ms = 100;
constexpr double zoom_step = 1.25;
constexpr double turn_step = 0.125; ///< as a fraction of the angle of view
const std::string cause = "camera";

QString classOf(const Robot& robot) {
    return QString::fromStdString(robot.view().spawn.class_name).section('.', -1);
}

} // namespace

CameraDesk::CameraDesk(const DeskContext& context) : desk_(context), view_(*context.views.camera) {
    for (QTimer* const timer : {&answer_timer_, &turn_timer_, &set_timer_})
        timer->setSingleShot(true);
    connect(&answer_timer_, &QTimer::timeout, this, &CameraDesk::refresh);
    connect(&turn_timer_, &QTimer::timeout, this, &CameraDesk::sendTurn);
    connect(&set_timer_, &QTimer::timeout, this, &CameraDesk::sendSet);
}

void CameraDesk::registerCommands() {
    const QString group = tr("Camera");
    const auto zooms = [this] { return canZoom(); };
    const auto zoom = [this](double factor) {
        return [this, factor](bool) {
            mount_.zoomBy(factor);
            showCamera();
            sendSetSoon();
        };
    };
    desk_.commands.add({"camera.zoom_in",
                        tr("Zoom camera in"),
                        group,
                        tr("A narrower angle of view"),
                        "plus",
                        {QKeySequence("Alt++"), QKeySequence("Alt+=")}},
                       zoom(zoom_step), zooms);
    desk_.commands.add({"camera.zoom_out",
                        tr("Zoom camera out"),
                        group,
                        tr("A wider angle of view"),
                        "minus",
                        {QKeySequence("Alt+-")}},
                       zoom(1.0 / zoom_step), zooms);
    desk_.commands.add(
        {"camera.zoom_default",
         tr("Camera's own angle of view"),
         group,
         tr("As it was when it was spawned"),
         "",
         {QKeySequence("Alt+0")}},
        [this](bool) {
            mount_.resetZoom();
            showCamera();
            sendSetSoon();
        },
        zooms);
    registerTurnCommands();
    desk_.commands.add(
        {"camera.light",
         tr("Headlight"),
         group,
         tr("Switches the robot's headlight"),
         "sun",
         {QKeySequence("Alt+Shift+L")},
         true},
        [this](bool on) { desk_.selection.robot()->send(protocol::DriveSwitches{.light_on = on}, cause); },
        [this] { return live() && mount_.lightKnown(); });
    desk_.commands.add(
        {"camera.save",
         tr("Save picture…"),
         group,
         tr("What the camera shows now, as a file"),
         "export",
         {QKeySequence("Alt+Shift+S")}},
        [this](bool) { chooseWhereToSave(); }, [this] { return !view_.isEmpty(); });
    desk_.commands.add({"camera.port",
                        tr("Image server's port…"),
                        group,
                        tr("Where a real server's pictures come from; usually %1").arg(protocol::usual_port::image),
                        "",
                        {}},
                       [this](bool) { chooseImagePort(); });
}

void CameraDesk::registerTurnCommands() {
    const QString group = tr("Camera");
    const auto turns = [this] { return canTurn(); };
    const auto turnBy = [this](double right, double up) {
        return [this, right, up](bool) {
            if (mount_.turnBy(right * turn_step, up * turn_step))
                turnSoon();
        };
    };
    widgets::CommandRegistry& commands = desk_.commands;
    commands.add({"camera.left", tr("Turn camera left"), group, tr("Pans it"), "", {QKeySequence("Alt+Shift+Left")}},
                 turnBy(-1.0, 0.0), turns);
    commands.add({"camera.right", tr("Turn camera right"), group, tr("Pans it"), "", {QKeySequence("Alt+Shift+Right")}},
                 turnBy(1.0, 0.0), turns);
    commands.add({"camera.up", tr("Turn camera up"), group, tr("Tilts it"), "", {QKeySequence("Alt+Shift+Up")}},
                 turnBy(0.0, 1.0), turns);
    commands.add({"camera.down", tr("Turn camera down"), group, tr("Tilts it"), "", {QKeySequence("Alt+Shift+Down")}},
                 turnBy(0.0, -1.0), turns);
    commands.add(
        {"camera.center",
         tr("Look straight ahead"),
         group,
         tr("Pan and tilt back to zero"),
         "follow",
         {QKeySequence("Alt+Shift+Home")}},
        [this](bool) {
            mount_.center();
            sendTurn();
        },
        turns);
}

void CameraDesk::wire() {
    QList<QAction*> shown;
    for (const char* const id : {"camera.center", "camera.light", "camera.save"})
        shown << desk_.commands.action(id);
    view_.setActions(shown);
    server_port_ = static_cast<quint16>(QSettings().value("server/image_port", server_port_).toUInt());
    connect(&desk_.control.simulator(), &server::SimulatorHost::channelsOpened, this,
            [this](const server::ChannelPorts& ports) {
                embedded_port_ = ports.image;
                refresh();
            });
    connect(&desk_.control, &MissionControl::classesChanged, this, &CameraDesk::refresh);
    connect(&desk_.control, &MissionControl::robotLinkChanged, this, &CameraDesk::refresh);
    connect(&desk_.control, &MissionControl::robotUpdated, this, [this](int id, const auto& update) {
        if (id == desk_.selection.id())
            take(*update);
    });
    connect(&desk_.selection, &Selection::changed, this, &CameraDesk::select);
    wireView();
    wireFeed();
}

void CameraDesk::wireView() {
    connect(&view_, &widgets::CameraView::wantsPicturesChanged, this, &CameraDesk::refresh);
    connect(&view_, &widgets::CameraView::zoomRequested, this, [this](double fov_rad) {
        if (!canZoom())
            return;
        mount_.zoomTo(fov_rad);
        showCamera();
        sendSetSoon();
    });
    connect(&view_, &widgets::CameraView::turnRequested, this, &CameraDesk::turn);
    connect(&view_, &widgets::CameraView::cameraChosen, this, [this](const QString& name) {
        mount_.show(name.toStdString());
        showCamera();
        attach();
    });
}

void CameraDesk::wireFeed() {
    connect(&feed_, &mission::CameraFeed::statusChanged, this, [this](const link::ImageStatus& status) {
        const bool moved = status.state != feed_status_.state || status.reason != feed_status_.reason;
        if (status.local_address != feed_status_.local_address)
            attached_.clear();
        feed_status_ = status;
        if (moved)
            refresh();
    });
    connect(&feed_, &mission::CameraFeed::unreadable, this, [this](const QString& reason) {
        view_.setEmpty(tr("No picture"), reason, desk_.commands.action("camera.port"));
    });
    connect(&feed_, &mission::CameraFeed::pictureArrived, this, [this](const QImage& picture, double frames_per_s) {
        if (!live() || !view_.wantsPictures() || !hasCamera().value_or(true))
            return; // It belongs to the robot that was selected before.
        const bool first = view_.isEmpty();
        view_.setPicture(picture, frames_per_s);
        if (first)
            showAbilities();
    });
}

bool CameraDesk::live() const {
    return robot() && !robot()->isReplay() && robot()->view().figures.spawned &&
           robot()->view().link.state == link::LinkState::Connected;
}

bool CameraDesk::canZoom() const {
    return !view_.isEmpty() && mount_.canZoom();
}

bool CameraDesk::canTurn() const {
    return live() && !view_.isEmpty() && mount_.canTurn();
}

std::optional<bool> CameraDesk::hasCamera() const {
    const QStringList& classes = desk_.control.world().camera_classes;
    if (!mount_.cameras().empty())
        return true;
    if (robot() && desk_.control.server().embedded && !classes.isEmpty())
        return classes.contains(classOf(*robot()), Qt::CaseInsensitive);
    return mount_.answered() ? std::optional(false) : std::nullopt;
}

void CameraDesk::select() {
    questions_ = 0;
    answer_timer_.stop();
    turn_timer_.stop();
    mount_ = {};
    attached_.clear();
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
        const ServerTarget& server = desk_.control.server();
        if (server.embedded)
            feed_.open("127.0.0.1", embedded_port_);
        else
            feed_.open(server.host, server_port_);
        ask();
        attach();
    }
    showAbilities();
}

void CameraDesk::showAbilities() {
    desk_.commands.action("camera.light")->setChecked(mount_.lightOn());
    desk_.commands.refresh();
}

/// Asks which cameras the robot has, unless a behavior drives it: of two questions a server answers only the newest,
/// and the behavior's questions are more important.
void CameraDesk::ask() {
    if (mount_.answered() || answer_timer_.isActive() || questions_ >= most_questions || robot()->running())
        return;
    ++questions_;
    answer_timer_.start(answer_patience_ms);
    desk_.selection.robot()->send(protocol::GetConfiguration{"Camera"}, cause);
}

QString CameraDesk::camerasHere() const {
    const QStringList& classes = desk_.control.world().camera_classes;
    return classes.isEmpty() ? tr("Spawn a robot that has a camera.")
                             : tr("Spawn a robot that has one: %1.").arg(classes.join(", "));
}

/// Returns true if there can be no picture; the view then says why, and what the user can do.
bool CameraDesk::showWhatIsMissing() {
    const bool embedded = desk_.control.server().embedded;
    if (!robot()) {
        view_.setEmpty(tr("No robot yet"),
                       tr("Pictures of the selected robot's camera appear here. %1").arg(camerasHere()));
    } else if (robot()->isReplay()) {
        view_.setEmpty(tr("A recording has no pictures"), tr("Pictures come from a server while a robot runs."));
    } else if (!live()) {
        view_.setEmpty(tr("%1 is not there").arg(nameOf(*robot())), tr("Its pictures appear here once it is spawned."));
    } else if (!hasCamera().value_or(true)) {
        view_.setEmpty(tr("%1 has no camera").arg(nameOf(*robot())),
                       tr("%1 carries none. %2").arg(classOf(*robot()), camerasHere()));
    } else if (embedded && embedded_port_ == 0) {
        view_.setEmpty(tr("No image server"),
                       tr("The embedded simulator could not open a port for pictures. Connect anew."));
    } else {
        if (feed_status_.state == link::ImageState::Waiting && view_.wantsPictures())
            view_.setEmpty(tr("No image server"), feed_status_.reason,
                           embedded ? nullptr : desk_.commands.action("camera.port"));
        else if (view_.isEmpty())
            view_.setEmpty(tr("Waiting for the first picture"), {});
        return false;
    }
    return true;
}

void CameraDesk::take(const mission::SessionUpdate& update) {
    using News = mission::CameraMount::News;
    for (const protocol::InfoLine& line : update.lines) {
        const News news = mount_.take(line.message);
        if (news == News::Cameras)
            answer_timer_.stop();
        if (news == News::Cameras || news == News::Picture)
            showCamera();
        if (news == News::Cameras)
            refresh();
        else if (news == News::Abilities)
            showAbilities();
        if (mount_.takeAnswered())
            sendSet();
    }
    if (live() != was_live_)
        refresh();
}

void CameraDesk::showCamera() {
    QStringList names;
    for (const mission::CameraMount::Camera& camera : mount_.cameras())
        names << QString::fromStdString(camera.configuration.name);
    const auto* const camera = mount_.shown();
    view_.setSource(robot() ? nameOf(*robot()) : QString(), names,
                    camera ? QString::fromStdString(camera->configuration.name) : QString());
    if (camera)
        view_.setZoom({camera->fov_rad, camera->configuration.smallest_fov_rad.value_or(camera->fov_rad),
                       camera->configuration.largest_fov_rad.value_or(camera->fov_rad)});
}

/// Tells the server which camera this viewer wants to see; otherwise several cameras are shown as a mosaic.
void CameraDesk::attach() {
    const auto* const shown = mount_.shown();
    if (!shown || feed_status_.local_address.isEmpty())
        return;
    const std::string& camera = shown->configuration.name;
    const QString wanted = QString("%1/%2/%3/%4")
                               .arg(desk_.selection.id())
                               .arg(nameOf(*robot()), QString::fromStdString(camera), feed_status_.local_address);
    const auto name = protocol::Token::make(nameOf(*robot()).toStdString());
    const auto address = protocol::Token::make(feed_status_.local_address.toStdString());
    const auto camera_name = protocol::Name::make(camera);
    if (wanted == attached_ || !name || !address || !camera_name)
        return;
    attached_ = wanted;
    queueSet(protocol::AttachCamera{*name, *address, *camera_name});
}

void CameraDesk::queueSet(const protocol::Command& set) {
    mount_.queue(set);
    sendSetSoon();
}

void CameraDesk::sendSetSoon() {
    if (!set_timer_.isActive())
        sendSet();
}

void CameraDesk::sendSet() {
    set_timer_.stop();
    if (!live())
        return;
    if (const auto set = mount_.next()) {
        desk_.selection.robot()->send(*set, cause);
        set_timer_.start(set_patience_ms);
    }
}

void CameraDesk::turn(double right_rad, double up_rad) {
    if (canTurn() && mount_.turn(right_rad, up_rad))
        turnSoon();
}

void CameraDesk::turnSoon() {
    mount_.setTurning(true);
    if (!turn_timer_.isActive())
        turn_timer_.start(turn_interval_ms);
}

void CameraDesk::sendTurn() {
    mount_.setTurning(false);
    if (const auto drive = mount_.drive(); drive && canTurn())
        desk_.selection.robot()->send(*drive, cause);
}

void CameraDesk::chooseImagePort() {
    bool chosen = false;
    const int port =
        QInputDialog::getInt(desk_.window, tr("Image server"), tr("Port of the image server, beside the bot port"),
                             server_port_, 1, 65535, 1, &chosen);
    if (!chosen)
        return;
    QSettings().setValue("server/image_port", port);
    server_port_ = static_cast<quint16>(port);
    refresh();
}

void CameraDesk::chooseWhereToSave() {
    const QImage picture = view_.picture(); // The current one, not the one when the dialog closes.
    const QString path =
        QFileDialog::getSaveFileName(desk_.window, tr("Save picture"), tr("camera.png"), tr("Pictures (*.png *.jpg)"));
    if (!path.isEmpty())
        savePicture(picture, QFileInfo(path).suffix().isEmpty() ? path + ".png" : path);
}

void CameraDesk::savePicture(const QImage& picture, const QString& path) {
    if (!picture.save(path))
        return desk_.notices.say(
            Severity::Error, "picture",
            tr("The picture could not be saved as %1. Choose a folder that can be written to, and .png or .jpg.")
                .arg(path));
    desk_.notices.note("picture", tr("Saved the picture %1.").arg(path));
}

} // namespace usar::app
