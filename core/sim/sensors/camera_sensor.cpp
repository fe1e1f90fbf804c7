#include "core/sim/sensors/camera_sensor.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace usar::sim {

std::vector<protocol::Setting> CameraSensor::settings() const {
    return {setting("CameraDefFov", default_rad_), setting("CameraMinFov", smallest_rad_),
            setting("CameraMaxFov", largest_rad_)};
}

std::optional<protocol::Response> CameraSensor::set(const protocol::Command& command, bool) {
    const auto* const zoom = std::get_if<protocol::ZoomCamera>(&command);
    if (!zoom)
        return std::nullopt;
    const double wanted_rad = zoom->field_of_view_rad;
    fov_rad_ = wanted_rad == 0.0 ? default_rad_ : std::clamp(wanted_rad, smallest_rad_, largest_rad_);
    const bool ok = wanted_rad > smallest_rad_ && wanted_rad <= largest_rad_;
    protocol::Response answer = this->answer(ok);
    answer.parts.push_back({"Name", model().name, ok, fov_rad_});
    return answer;
}

int CameraSensor::pixels(std::string_view key, double otherwise) const {
    return static_cast<int>(std::clamp(std::round(number(key, otherwise)), 16.0, 1280.0));
}

std::vector<protocol::Setting> CameraSensor::udkSettings() const {
    const auto whole = [](std::string key, int value) {
        return protocol::Setting{std::move(key), std::to_string(value), static_cast<double>(value)};
    };
    // UDK keeps its fields of view in degrees, our files in radians with four decimals.
    const auto angle = [](std::string key, double angle_rad) {
        const double angle_deg = degrees(angle_rad);
        const double whole_deg = std::round(angle_deg);
        return setting(std::move(key), std::abs(angle_deg - whole_deg) < 0.03 ? whole_deg : angle_deg);
    };
    return {whole("TextureOffsetX", 0),
            whole("TextureOffsetY", 0),
            whole("TextureResolutionX", pixels("width", 320.0)),
            whole("TextureResolutionY", pixels("height", 240.0)),
            angle("CameraDefFov", default_rad_),
            angle("CameraMinFov", smallest_rad_),
            angle("CameraMaxFov", largest_rad_),
            angle("CameraFov", fov_rad_)};
}

SeenFrom CameraSensor::view(const RobotBody& body) const {
    return {.camera = model().name,
            .camera_in_map = body.link_in_map(model().link) * model().sensor_in_link.isometry(),
            .field_of_view_rad = fov_rad_,
            .width_px = pixels("width", 320.0),
            .height_px = pixels("height", 240.0)};
}

} // namespace usar::sim
