#include "core/mission/hand/camera_mount.h"

#include <algorithm>

#include <QString>

#include "core/base/geometry.h"
#include "core/base/text.h"

namespace usar::mission {

namespace {

constexpr double most_pan_rad = pi;
constexpr double most_tilt_rad = pi / 2.0;

bool isOfCamera(const std::string& package) {
    return QString::fromStdString(package).contains("camera", Qt::CaseInsensitive);
}

} // namespace

CameraMount::News CameraMount::take(const protocol::InfoMessage& message) {
    if (const auto* configured = std::get_if<protocol::ConfigurationInfo>(&message))
        return sameWord(configured->type, "Camera") ? takeCameras(protocol::cameraConfigurationsOf(*configured))
                                                    : News::None;
    if (const auto* package = std::get_if<protocol::PackageState>(&message))
        return takePackage(*package);
    if (const auto* response = std::get_if<protocol::Response>(&message))
        return takeResponse(*response);
    if (const auto* state = std::get_if<protocol::RobotState>(&message))
        return takeLight(*state);
    return News::None;
}

CameraMount::News CameraMount::takeCameras(const std::vector<protocol::CameraConfiguration>& cameras) {
    answered_ = true;
    cameras_.clear();
    for (const protocol::CameraConfiguration& camera : cameras)
        if (camera.default_fov_rad || camera.picture_width_px)
            cameras_.push_back(
                {camera, camera.fov_rad.value_or(camera.default_fov_rad.value_or(protocol::usual_camera_fov_rad))});
    shown_ = std::min(shown_, cameras_.empty() ? 0 : cameras_.size() - 1);
    return News::Cameras;
}

CameraMount::News CameraMount::takePackage(const protocol::PackageState& state) {
    if (!isOfCamera(state.name))
        return News::None;
    const bool is_new = !package_;
    if (is_new)
        package_.emplace(Package{state.name, {}});
    if (!turning_ && package_->wanted_rad.empty())
        for (const protocol::LinkState& link : state.links)
            package_->wanted_rad[static_cast<int>(link.link)] = link.value;
    return is_new ? News::Abilities : News::None;
}

CameraMount::News CameraMount::takeResponse(const protocol::Response& response) {
    if (!sameWord(response.type, "Camera"))
        return News::None;
    for (const protocol::ResponsePart& part : response.parts)
        for (Camera& camera : cameras_)
            if (part.fov_rad && sameWord(camera.configuration.name, part.value))
                camera.fov_rad = *part.fov_rad;
    set_answered_ = true;
    return News::Picture;
}

CameraMount::News CameraMount::takeLight(const protocol::RobotState& state) {
    if (!state.light_on || light_on_ == *state.light_on)
        return News::None;
    light_on_ = *state.light_on;
    return News::Abilities;
}

void CameraMount::show(const std::string& name) {
    for (std::size_t i = 0; i < cameras_.size(); ++i)
        if (cameras_[i].configuration.name == name)
            shown_ = i;
}

bool CameraMount::canZoom() const {
    const Camera* const camera = shown();
    return camera && camera->configuration.largest_fov_rad > camera->configuration.smallest_fov_rad;
}

void CameraMount::zoomTo(double fov_rad) {
    if (!canZoom())
        return;
    Camera& camera = cameras_[shown_];
    camera.fov_rad = std::clamp(fov_rad, camera.configuration.smallest_fov_rad.value_or(fov_rad),
                                *camera.configuration.largest_fov_rad);
    queue(protocol::ZoomCamera{camera.fov_rad, protocol::Name::mended(camera.configuration.name)});
}

void CameraMount::zoomBy(double factor) {
    if (canZoom())
        zoomTo(shown()->fov_rad / factor);
}

void CameraMount::resetZoom() {
    if (canZoom())
        zoomTo(shown()->configuration.default_fov_rad.value_or(shown()->fov_rad));
}

bool CameraMount::turnBy(double right, double up) {
    const double fov_rad = shown() ? shown()->fov_rad : protocol::usual_camera_fov_rad;
    return turn(right * fov_rad, up * fov_rad);
}

bool CameraMount::turn(double right_rad, double up_rad) {
    if (!package_ || package_->wanted_rad.empty())
        return false;
    std::map<int, double>& wanted_rad = package_->wanted_rad;
    const int tilt_link = wanted_rad.size() > 1 ? 2 : 1;
    if (tilt_link == 2)
        wanted_rad[1] = std::clamp(wanted_rad[1] + right_rad, -most_pan_rad, most_pan_rad);
    wanted_rad[tilt_link] = std::clamp(wanted_rad[tilt_link] + up_rad, -most_tilt_rad, most_tilt_rad);
    return true;
}

void CameraMount::center() {
    if (package_)
        for (auto& [link, value_rad] : package_->wanted_rad)
            value_rad = 0.0;
}

std::optional<protocol::PackageDrive> CameraMount::drive() const {
    const auto name = protocol::Token::make(package_ ? package_->name : std::string());
    if (!package_ || !name)
        return std::nullopt;
    protocol::PackageDrive drive{*name};
    for (const auto& [link, value_rad] : package_->wanted_rad)
        drive.links.push_back({link, value_rad});
    return drive;
}

void CameraMount::queue(const protocol::Command& set) {
    std::erase_if(sets_, [&](const protocol::Command& waiting) { return waiting.index() == set.index(); });
    sets_.push_back(set);
}

std::optional<protocol::Command> CameraMount::next() {
    if (sets_.empty())
        return std::nullopt;
    protocol::Command first = sets_.front();
    sets_.pop_front();
    return first;
}

} // namespace usar::mission
