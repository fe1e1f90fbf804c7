#include "app/camera_desk.h"

#include <algorithm>
#include <cmath>

#include "app/robot_name.h"
#include "core/base/text.h"

namespace usar::app {

namespace {

constexpr int most_questions = 3;
constexpr int answer_patience_ms = 2500;
constexpr int set_patience_ms = 500;
constexpr int turn_interval_ms = 100;
constexpr double most_pan_rad = pi;
constexpr double most_tilt_rad = pi / 2.0;
const std::string cause = "camera";

QString classOf(const Robot& robot) {
    return QString::fromStdString(robot.view().spawn.class_name).section('.', -1);
}

bool isOfCamera(const std::string& package) {
    return QString::fromStdString(package).contains("camera", Qt::CaseInsensitive);
}

} // namespace

CameraDesk::CameraDesk(MissionControl& control, widgets::CameraView& view) : control_(control), view_(view) {
    for (QTimer* const timer : {&answer_timer_, &turn_timer_, &set_timer_})
        timer->setSingleShot(true);
    connect(&answer_timer_, &QTimer::timeout, this, &CameraDesk::refresh);
    connect(&turn_timer_, &QTimer::timeout, this, &CameraDesk::sendTurn);
    connect(&set_timer_, &QTimer::timeout, this, &CameraDesk::sendSet);
    connect(&view_, &widgets::CameraView::wantsPicturesChanged, this, &CameraDesk::refresh);
    connect(&view_, &widgets::CameraView::zoomRequested, this, &CameraDesk::requestZoom);
    connect(&view_, &widgets::CameraView::turnRequested, this, &CameraDesk::turn);
    connect(&view_, &widgets::CameraView::cameraChosen, this, [this](const QString& name) {
        for (std::size_t i = 0; i < cameras_.size(); ++i)
            if (QString::fromStdString(cameras_[i].configuration.name) == name)
                shown_ = i;
        showCamera();
        attach();
    });
    connect(&feed_, &CameraFeed::statusChanged, this, [this](const link::ImageStatus& status) {
        const bool moved = status.state != feed_status_.state || status.reason != feed_status_.reason;
        if (status.local_address != feed_status_.local_address)
            attached_.clear();
        feed_status_ = status;
        if (moved)
            refresh();
    });
    connect(&feed_, &CameraFeed::unreadable, this,
            [this](const QString& reason) { showEmpty(tr("No picture"), reason, port_action_); });
    connect(&feed_, &CameraFeed::pictureArrived, this, [this](const QImage& picture, double frames_per_s) {
        if (!live() || !view_.wantsPictures() || !hasCamera().value_or(true))
            return; // of the robot before
        const bool first = view_.isEmpty();
        view_.setPicture(picture, frames_per_s);
        if (first)
            emit changed();
    });
}

bool CameraDesk::live() const {
    return robot() && !robot()->isReplay() && robot()->view().figures.spawned &&
           robot()->view().link.state == link::LinkState::Connected;
}

std::optional<bool> CameraDesk::hasCamera() const {
    if (!cameras_.empty())
        return true;
    if (robot() && control_.server().embedded && !camera_classes_.isEmpty())
        return camera_classes_.contains(classOf(*robot()), Qt::CaseInsensitive);
    return answered_ ? std::optional(false) : std::nullopt;
}

void CameraDesk::select(int id) {
    selected_ = id;
    questions_ = 0;
    answered_ = false;
    answer_timer_.stop();
    turn_timer_.stop();
    sets_.clear();
    cameras_.clear();
    shown_ = 0;
    package_.reset();
    attached_.clear();
    light_on_ = lamp_known_ = false;
    feed_.setWanted(false);
    view_.setEmpty(tr("Waiting for the first picture"), {});
    showCamera();
    refresh();
}

void CameraDesk::setEmbeddedPort(quint16 port) {
    embedded_port_ = port;
    refresh();
}

void CameraDesk::setCameraClasses(const QStringList& classes) {
    camera_classes_ = classes;
    refresh();
}

void CameraDesk::setServerPort(quint16 port) {
    server_port_ = port;
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
        ask();
        attach();
    }
    emit changed();
}

/// Which cameras it has, unless a behavior flies it: a server answers the newest of two questions only, and the
/// behavior's matter more.
void CameraDesk::ask() {
    if (answered_ || answer_timer_.isActive() || questions_ >= most_questions || robot()->running())
        return;
    ++questions_;
    answer_timer_.start(answer_patience_ms);
    control_.robot(selected_)->send(protocol::GetConfiguration{"Camera"}, cause);
}

QString CameraDesk::camerasHere() const {
    return camera_classes_.isEmpty() ? tr("Spawn a robot that has a camera.")
                                     : tr("Spawn a robot that has one: %1.").arg(camera_classes_.join(", "));
}

/// True where there is nothing to be seen; the view says why and what helps.
bool CameraDesk::showWhatIsMissing() {
    if (!robot()) {
        showEmpty(tr("No robot yet"), tr("Pictures of the selected robot's camera appear here. %1").arg(camerasHere()));
    } else if (robot()->isReplay()) {
        showEmpty(tr("A recording has no pictures"), tr("Pictures come from a server while a robot runs."));
    } else if (!live()) {
        showEmpty(tr("%1 is not there").arg(nameOf(*robot())), tr("Its pictures appear here once it is spawned."));
    } else if (!hasCamera().value_or(true)) {
        showEmpty(tr("%1 has no camera").arg(nameOf(*robot())),
                  tr("%1 carries none. %2").arg(classOf(*robot()), camerasHere()));
    } else if (control_.server().embedded && embedded_port_ == 0) {
        showEmpty(tr("No image server"),
                  tr("The embedded simulator could not open a port for pictures. Connect anew."));
    } else {
        if (feed_status_.state == link::ImageState::Waiting && view_.wantsPictures())
            showEmpty(tr("No image server"), feed_status_.reason, control_.server().embedded ? nullptr : port_action_);
        else if (view_.isEmpty())
            showEmpty(tr("Waiting for the first picture"), {});
        return false;
    }
    return true;
}

void CameraDesk::showEmpty(const QString& title, const QString& hint, QAction* action) {
    view_.setEmpty(title, hint, action);
}

void CameraDesk::take(const mission::SessionUpdate& update) {
    for (const protocol::InfoLine& line : update.lines)
        takeMessage(line.message);
    if (live() != was_live_)
        refresh();
}

void CameraDesk::takeMessage(const protocol::InfoMessage& message) {
    if (const auto* configured = std::get_if<protocol::ConfigurationInfo>(&message)) {
        if (sameWord(configured->type, "Camera"))
            takeCameras(protocol::cameraConfigurationsOf(*configured));
    } else if (const auto* package = std::get_if<protocol::PackageState>(&message)) {
        if (!isOfCamera(package->name))
            return;
        const bool news = !package_;
        if (news)
            package_.emplace(Package{package->name, {}});
        if (!turn_timer_.isActive() && package_->wanted.empty())
            for (const protocol::LinkState& link : package->links)
                package_->wanted[static_cast<int>(link.link)] = link.value;
        if (news)
            emit changed();
    } else if (const auto* result = std::get_if<protocol::Response>(&message)) {
        if (!sameWord(result->type, "Camera"))
            return;
        for (const protocol::ResponsePart& part : result->parts)
            for (Camera& camera : cameras_)
                if (part.fov_rad && sameWord(camera.configuration.name, part.value))
                    camera.fov_rad = *part.fov_rad;
        showCamera();
        sendSet();
    } else if (const auto* state = std::get_if<protocol::RobotState>(&message)) {
        if (!state->light_on || (lamp_known_ && light_on_ == *state->light_on))
            return;
        lamp_known_ = true;
        light_on_ = *state->light_on;
        emit changed();
    }
}

void CameraDesk::takeCameras(const std::vector<protocol::CameraConfiguration>& cameras) {
    answered_ = true;
    answer_timer_.stop();
    cameras_.clear();
    for (const protocol::CameraConfiguration& camera : cameras)
        if (camera.default_fov_rad || camera.picture_width_px)
            cameras_.push_back({camera, camera.fov_rad.value_or(camera.default_fov_rad.value_or(1.396))});
    shown_ = std::min(shown_, cameras_.empty() ? 0 : cameras_.size() - 1);
    showCamera();
    refresh();
}

void CameraDesk::showCamera() {
    QStringList names;
    for (const Camera& camera : cameras_)
        names << QString::fromStdString(camera.configuration.name);
    view_.setSource(robot() ? nameOf(*robot()) : QString(), names, names.value(static_cast<int>(shown_)));
    if (cameras_.empty())
        return;
    const Camera& camera = cameras_[shown_];
    view_.setZoom({camera.fov_rad, camera.configuration.smallest_fov_rad.value_or(camera.fov_rad),
                   camera.configuration.largest_fov_rad.value_or(camera.fov_rad)});
}

/// Tells the server which camera this viewer wants to see. Without it several cameras come as a mosaic.
void CameraDesk::attach() {
    if (cameras_.empty() || feed_status_.local_address.isEmpty())
        return;
    const std::string& camera = cameras_[shown_].configuration.name;
    const QString wanted = QString("%1/%2/%3/%4")
                               .arg(selected_)
                               .arg(nameOf(*robot()), QString::fromStdString(camera), feed_status_.local_address);
    const auto name = protocol::Token::make(nameOf(*robot()).toStdString());
    const auto address = protocol::Token::make(feed_status_.local_address.toStdString());
    const auto camera_name = protocol::Name::make(camera);
    if (wanted == attached_ || !name || !address || !camera_name)
        return;
    attached_ = wanted;
    queueSet(protocol::AttachCamera{*name, *address, *camera_name});
}

bool CameraDesk::canZoom() const {
    return !view_.isEmpty() && !cameras_.empty() &&
           cameras_[shown_].configuration.largest_fov_rad > cameras_[shown_].configuration.smallest_fov_rad;
}

bool CameraDesk::canTurn() const {
    return live() && !view_.isEmpty() && package_.has_value();
}

bool CameraDesk::canLight() const {
    return live() && lamp_known_;
}

void CameraDesk::zoomBy(double factor) {
    if (canZoom())
        requestZoom(cameras_[shown_].fov_rad / factor);
}

void CameraDesk::resetZoom() {
    if (canZoom())
        requestZoom(cameras_[shown_].configuration.default_fov_rad.value_or(cameras_[shown_].fov_rad));
}

void CameraDesk::requestZoom(double fov_rad) {
    if (!canZoom())
        return;
    Camera& camera = cameras_[shown_];
    camera.fov_rad = std::clamp(fov_rad, *camera.configuration.smallest_fov_rad, *camera.configuration.largest_fov_rad);
    showCamera();
    queueSet(protocol::ZoomCamera{camera.fov_rad, protocol::Name::mended(camera.configuration.name)});
}

void CameraDesk::queueSet(const protocol::Command& command) {
    std::erase_if(sets_, [&](const protocol::Command& waiting) { return waiting.index() == command.index(); });
    sets_.push_back(command);
    if (!set_timer_.isActive())
        sendSet();
}

void CameraDesk::sendSet() {
    set_timer_.stop();
    if (sets_.empty() || !live())
        return;
    control_.robot(selected_)->send(sets_.front(), cause);
    sets_.pop_front();
    set_timer_.start(set_patience_ms);
}

void CameraDesk::turnBy(double right, double up) {
    const double fov_rad = cameras_.empty() ? 1.396 : cameras_[shown_].fov_rad;
    turn(right * fov_rad, up * fov_rad);
}

/// Two links pan and tilt; a single one tilts, as AirRobot's does.
void CameraDesk::turn(double right_rad, double up_rad) {
    if (!canTurn() || package_->wanted.empty())
        return;
    const int tilt_link = package_->wanted.size() > 1 ? 2 : 1;
    if (tilt_link == 2)
        package_->wanted[1] = std::clamp(package_->wanted[1] + right_rad, -most_pan_rad, most_pan_rad);
    package_->wanted[tilt_link] = std::clamp(package_->wanted[tilt_link] + up_rad, -most_tilt_rad, most_tilt_rad);
    if (!turn_timer_.isActive())
        turn_timer_.start(turn_interval_ms);
}

void CameraDesk::center() {
    if (!canTurn())
        return;
    for (auto& [link, value] : package_->wanted)
        value = 0.0;
    sendTurn();
}

void CameraDesk::sendTurn() {
    const auto name = package_ ? protocol::Token::make(package_->name) : protocol::Token::make("");
    if (!canTurn() || !name)
        return;
    protocol::PackageDrive drive{*name};
    for (const auto& [link, value] : package_->wanted)
        drive.links.push_back({link, value});
    control_.robot(selected_)->send(drive, cause);
}

void CameraDesk::setLight(bool on) {
    if (canLight())
        control_.robot(selected_)->send(protocol::DriveSwitches{.light_on = on}, cause);
}

} // namespace usar::app
