#include "core/mission/sensor_watch.h"

#include <array>

namespace usar::mission {

namespace {

constexpr std::array names{"Sonar", "RangeScanner", "INS", "GroundTruth", "Odometry", "Encoder"};

/// Place in `names`; nothing for what is not watched.
struct Place {
    using Index = std::optional<std::size_t>;
    Index operator()(const protocol::SonarReadings&) const { return 0; }
    Index operator()(const protocol::RangeScan&) const { return 1; }
    Index operator()(const protocol::InsReading&) const { return 2; }
    Index operator()(const protocol::GroundTruthReading&) const { return 3; }
    Index operator()(const protocol::OdometryReading&) const { return 4; }
    Index operator()(const protocol::EncoderReadings&) const { return 5; }
    Index operator()(const auto&) const { return std::nullopt; }
};

} // namespace

void SensorWatch::saw(const protocol::InfoMessage& message, Seconds now) {
    if (const auto place = std::visit(Place{}, message))
        sensors_[*place] = Seen{.last = now};
}

std::vector<std::string> SensorWatch::newlySilent(Seconds now) {
    std::vector<std::string> silent;
    for (std::size_t i = 0; i < names.size(); ++i) {
        auto& sensor = sensors_[i];
        if (!sensor || sensor->reported || now - sensor->last <= limit_)
            continue;
        sensor->reported = true;
        silent.emplace_back(names[i]);
    }
    return silent;
}

} // namespace usar::mission
