#include "core/mission/fleet/equipment.h"

#include "core/base/alternatives.h"

namespace usar::mission {

void Equipment::take(const protocol::InfoLine& line, Seconds now) {
    std::visit(Overloaded{[this](const protocol::RobotState& state) { kind_ = state.kind; },
                          [this](const protocol::RangeScan&) { scanner_ = true; },
                          [this](const protocol::SonarReadings&) { sonars_ = true; },
                          [this](const protocol::GeometryInfo& geometry) {
                              if (!geometry.items.empty())
                                  takePart(geometry.type);
                          },
                          [this](const protocol::ConfigurationInfo& configuration) {
                              if (!configuration.items.empty())
                                  takePart(configuration.type);
                          },
                          [](const auto&) {}},
               line.message);
    if (!first_heard_ || now < *first_heard_)
        first_heard_ = now;
    settled_ = settled_ || now - *first_heard_ > patience;
}

void Equipment::takePart(const std::string& type) {
    scanner_ = scanner_ || type == protocol::RangeScan{}.type;
    sonars_ = sonars_ || type == "Sonar";
}

void Equipment::take(const agent::BehaviorStatus& status) {
    told_status_ = true;
    recharges_ = recharges_ || status.range_left_m || status.charges > 0;
}

bool Equipment::mayFly() const {
    return kind_ == protocol::VehicleKind::Aerial || kind_ == protocol::VehicleKind::Unknown;
}

} // namespace usar::mission
