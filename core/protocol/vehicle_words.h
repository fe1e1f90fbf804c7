// The words by which servers call their kinds of vehicles, in STA, GEO and CONF.
#pragma once

#include <string_view>

#include "core/protocol/info/robot_state.h"

namespace usar::protocol {

/// In any case and of any age: LeggedVehicle is a later LeggedRobot, BaseMachine an older StaticPlatform. Unknown for
/// everything else.
VehicleKind vehicleKindOf(std::string_view word);

/// UT2004's word; empty for Unknown.
std::string_view wordOf(VehicleKind kind);

} // namespace usar::protocol
