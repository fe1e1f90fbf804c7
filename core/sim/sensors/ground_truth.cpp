#include "core/sim/sensors/ground_truth.h"

#include <utility>

namespace usar::sim {

GroundTruth::GroundTruth(std::string name) : name_(std::move(name)) {}

protocol::GroundTruthReading GroundTruth::measure(const Pose& base_in_map, Seconds now) const {
    return {now, name_, base_in_map};
}

} // namespace usar::sim
