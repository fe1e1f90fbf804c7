#include "core/protocol/zero_drives.h"

namespace usar::protocol {

std::vector<Command> zeroDrives(VehicleKind kind) {
    switch (kind) {
    case VehicleKind::Ground:
        return {no_spin};
    case VehicleKind::Aerial:
        return {no_flight};
    case VehicleKind::Nautic:
        return {no_thrust};
    case VehicleKind::Legged:
    case VehicleKind::StaticPlatform:
        return {};
    case VehicleKind::Unknown:
        break;
    }
    return {no_flight, no_spin};
}

} // namespace usar::protocol
