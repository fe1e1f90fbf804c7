// A camera as the bot port knows it: an angle of view that SET can change. Pictures come from the image server.
#pragma once

#include "core/sim/camera/camera_scene.h"
#include "core/sim/sensors/sensor.h"

namespace usar::sim {

/// Settings: fov, min_fov, max_fov (rad), width, height (pixels). Sends nothing at the tick (UT2004).
class CameraSensor : public Sensor {
public:
    CameraSensor(const SensorModel& model, const SensorBirth& birth);
    void measure(const SensorView&, std::vector<protocol::InfoMessage>&) override {}
    std::vector<protocol::Setting> settings() const override;
    /// Zoom: 0 goes back to the default and yet reports Failed, as does an angle out of limits, which is cut
    /// (usarsim-protocol 4.8).
    std::optional<protocol::Response> set(const protocol::Command& command, bool at_rest) override;

    /// As UDK has them: degrees, the angle now, and where it is in the picture of a viewer that is attached to it.
    std::vector<protocol::Setting> udkSettings() const;
    double fieldOfView_rad() const { return fov_rad_; }
    SeenFrom view(const RobotBody& body) const;

private:
    int pixels(std::string_view key, double otherwise) const;

    double default_rad_;
    double smallest_rad_;
    double largest_rad_;
    double fov_rad_;
};

} // namespace usar::sim
