#include "core/protocol/zero_drives.h"

namespace usar::protocol {

std::vector<Command> zeroDrives(VehicleKind kind) {
    constexpr AerialDrive no_flight{0.0, 0.0, 0.0, 0.0};
    constexpr SkidDrive no_spin{0.0, 0.0};
    switch (kind) {
    case VehicleKind::Ground:
        return {no_spin};
    case VehicleKind::Aerial:
        return {no_flight};
    case VehicleKind::Nautic:
        return {NauticDrive{0.0, 0.0, 0.0}};
    case VehicleKind::Legged:
    case VehicleKind::StaticPlatform:
        return {};
    case VehicleKind::Unknown:
        break;
    }
    return {no_flight, no_spin};
}

} // namespace usar::protocol
