// What a robot can do, learnt by asking: GETCONF of the robot, its camera, its mission package and its ray.
#pragma once

#include <optional>

#include "core/modules/query.h"
#include "core/protocol/info/configurations.h"

namespace usar::submarine {

/// What the server said, or what is usual where it did not.
struct Limits {
    double propeller_rad_s = 160.0;
    double rudder_rad = 0.35;
    double stern_plane_rad = 0.35;
    double ray_reach_m = 20.0;
    std::optional<protocol::CameraConfiguration> camera;
    std::optional<protocol::PackageConfiguration> mount; ///< of the camera: link 1 pans, link 2 tilts
};

/// The thesis's three questions (3.5.1) and a fourth, one a logic call: the server holds one at a time and loses the
/// earlier one.
class Questionnaire {
public:
    /// Asks what has not been asked, or waits for the answer; true once all have been answered or given up.
    bool goOn(modules::ConfigurationModule& configuration);
    const Limits& limits() const { return limits_; }

private:
    void take(const protocol::ConfigurationInfo& answer);

    std::size_t asked_ = 0;
    Limits limits_;
};

} // namespace usar::submarine
