// A camera as the bot port knows it: a field of view that SET can change. Pictures come from the image server.
#pragma once

#include "core/protocol/usual_values.h"
#include "core/sim/camera/camera_scene.h"
#include "core/sim/sensors/sensor.h"

namespace usar::sim {

/// Settings: fov, min_fov, max_fov (rad), width, height (pixels). Sends nothing at the tick (UT2004).
class CameraSensor : public Sensor {
public:
    using Sensor::Sensor;
    void measure(const SensorView&, std::vector<protocol::InfoMessage>&) override {}
    std::vector<protocol::Setting> settings() const override;
    /// Zooms. 0 restores the default and yet reports Failed, as does an angle outside the limits, which is clamped
    /// (protocol.md 4.8).
    std::optional<protocol::Response> set(const protocol::Command& command, bool at_rest) override;

    /// Settings as UDK reports them: in degrees, with the current angle, and the camera's place in the picture of an
    /// attached viewer.
    std::vector<protocol::Setting> udkSettings() const;
    /// The camera with its current pose; the robot's name is left empty.
    SeenFrom view(const RobotBody& body) const;

private:
    /// A picture size in pixels, clamped to 16..1280.
    int pixels(std::string_view key, double otherwise) const;

    double default_rad_ = number("fov", protocol::usual_camera_fov_rad);
    double smallest_rad_ = number("min_fov", 0.349);
    double largest_rad_ = number("max_fov", 2.094);
    double fov_rad_ = default_rad_;
};

} // namespace usar::sim
