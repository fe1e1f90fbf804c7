#include "core/mission/fleet/equipment.h"

#include "core/base/alternatives.h"
#include "core/protocol/info/configurations.h"
#include "core/protocol/vehicle_words.h"

namespace usar::mission {

void Equipment::take(const protocol::InfoLine& line) {
    const auto know = [this](protocol::VehicleKind kind) {
        if (kind != protocol::VehicleKind::Unknown)
            kind_ = kind;
    };
    std::visit(Overloaded{[&](const protocol::RobotState& state) { know(state.kind); },
                          [&](const protocol::GeometryInfo& geometry) { know(protocol::vehicleKindOf(geometry.type)); },
                          [&](const protocol::ConfigurationInfo& told) {
                              if (const auto robot = protocol::robotConfigurationOf(told))
                                  know(robot->kind);
                          },
                          [](const auto&) {}},
               line.message);
}

void Equipment::take(const agent::BehaviorStatus& status) {
    told_status_ = true;
    recharges_ = recharges_ || status.range_left_m || status.charges > 0;
}

bool Equipment::mayFly() const {
    return kind_ == protocol::VehicleKind::Aerial || kind_ == protocol::VehicleKind::Unknown;
}

} // namespace usar::mission
