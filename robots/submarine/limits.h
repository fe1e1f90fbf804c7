// The limits of a robot, from GETCONF queries for the robot, its camera, its mission package and its ray.
#pragma once

#include <optional>

#include "core/modules/query.h"
#include "core/protocol/info/configurations.h"

namespace usar::submarine {

/// The limits that the server reported; the defaults are typical values for those that it did not report.
struct Limits {
    /// Greatest speed of the propeller.
    double propeller_rad_s = 160.0;
    double rudder_rad = 0.35;      ///< greatest angle to each side
    double stern_plane_rad = 0.35; ///< greatest angle up and down
    /// Ranges near this one mean that the ray hit nothing.
    double ray_reach_m = 20.0;
    std::optional<protocol::CameraConfiguration> camera; ///< nullopt if the robot has none
    std::optional<protocol::PackageConfiguration> mount; ///< mount of the camera: link 1 pans, link 2 tilts
};

/// Asks the thesis's three questions (3.5.1) and a fourth one. Asks one at a time, because the server keeps only the
/// newest question.
class Questionnaire {
public:
    /// Asks the next question or waits for its answer; call it once per tick. Returns true once all questions have been
    /// answered or given up.
    bool goOn(modules::ConfigurationModule& configuration);
    /// The values known so far; complete once `goOn` has returned true.
    const Limits& limits() const { return limits_; }

private:
    /// Stores what the answer has; the type of an answer decides which of the limits it is about.
    void take(const protocol::ConfigurationInfo& answer);

    std::size_t asked_ = 0; ///< number of questions that are answered or given up
    Limits limits_;
};

} // namespace usar::submarine
