// The exact pose, as a sensor: for scoring, and for the reset of the INS of a landed robot.
#pragma once

#include <string>

#include "core/protocol/sensors/pose.h"

namespace usar::sim {

/// No noise, no delay; the wire cuts it to 2 decimals (robots-and-worlds 4.5).
class GroundTruth {
public:
    explicit GroundTruth(std::string name = "GroundTruth");

    protocol::GroundTruthReading measure(const Pose& base_in_map, Seconds now) const;
    const std::string& name() const { return name_; }

private:
    std::string name_;
};

} // namespace usar::sim
