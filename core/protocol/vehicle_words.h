// The words for kinds of vehicles that servers use in STA, GEO and CONF.
#pragma once

#include <string_view>

#include "core/protocol/info/robot_state.h"

namespace usar::protocol {

/// Accepts any case, and the words of newer and older servers: LeggedVehicle is the newer word for LeggedRobot,
/// BaseMachine the older one for StaticPlatform. Returns Unknown for everything else.
VehicleKind vehicleKindOf(std::string_view word);

/// The word that UT2004 uses; empty for Unknown.
std::string_view wordOf(VehicleKind kind);

} // namespace usar::protocol
