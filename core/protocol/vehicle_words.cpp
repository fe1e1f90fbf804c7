#include "core/protocol/vehicle_words.h"

#include <array>
#include <utility>

#include "core/protocol/segments.h"

namespace usar::protocol {

namespace {

/// The words of each kind; the first one is the one we write.
constexpr std::array<std::pair<std::string_view, VehicleKind>, 7> vehicle_words = {{
    {"GroundVehicle", VehicleKind::Ground},
    {"AerialVehicle", VehicleKind::Aerial},
    {"NauticVehicle", VehicleKind::Nautic},
    {"LeggedRobot", VehicleKind::Legged},
    {"LeggedVehicle", VehicleKind::Legged},
    {"StaticPlatform", VehicleKind::StaticPlatform},
    {"BaseMachine", VehicleKind::StaticPlatform},
}};

} // namespace

VehicleKind vehicleKindOf(std::string_view word) {
    for (const auto& [name, kind] : vehicle_words) {
        if (sameWord(name, word))
            return kind;
    }
    return VehicleKind::Unknown;
}

std::string_view wordOf(VehicleKind kind) {
    for (const auto& [name, known] : vehicle_words) {
        if (known == kind)
            return name;
    }
    return {};
}

} // namespace usar::protocol
