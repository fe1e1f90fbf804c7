// The inertial navigation sensor: a pose estimate that drifts with the distance traveled. Model:
// robots-and-worlds.md 4.4.
#pragma once

#include <string>

#include "core/base/random.h"
#include "core/protocol/sensors/pose.h"

namespace usar::sim {

struct InsParameters {
    std::string name = "INS";
    double sigma = 0.05;       ///< relative standard deviation of each increment
    double precision = 1000.0; ///< bounds of the biases: position +-0.5 / precision, rotation +-0.5 / precision^2
    bool drifting = true;      ///< false: both biases are 0
};

/// Adds the true increments of each scan: angles times 1 + N(bias, sigma), positions plus the step's length times
/// N(bias, sigma), independently for x, y and z. Reports the spawn pose until two scans in a row have seen no rotation.
class Ins {
public:
    Ins(InsParameters parameters, const Pose& spawn_in_map, Random random);

    /// The estimate after one more scan, given the true pose.
    protocol::InsReading measure(const Pose& base_in_map);
    /// Sets the estimate and zeroes the biases. Returns false, and does nothing, unless the robot is at rest.
    bool set(const Pose& base_in_map, bool at_rest);

    const InsParameters& parameters() const { return parameters_; }

private:
    void integrate(const Pose& base_in_map);

    InsParameters parameters_;
    Random random_;
    Pose estimate_;
    Pose last_;
    Vec3 position_bias_ = Vec3::Zero();
    Vec3 rotation_bias_ = Vec3::Zero();
    int still_scans_ = 0;
    bool has_last_ = false;
    bool started_ = false; ///< two scans without rotation have been seen
};

} // namespace usar::sim
