#include "core/protocol/vehicle_words.h"

#include <algorithm>
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
    const auto found =
        std::ranges::find_if(vehicle_words, [word](const auto& row) { return sameWord(row.first, word); });
    return found == vehicle_words.end() ? VehicleKind::Unknown : found->second;
}

std::string_view wordOf(VehicleKind kind) {
    const auto found = std::ranges::find(vehicle_words, kind, [](const auto& row) { return row.second; });
    return found == vehicle_words.end() ? std::string_view() : found->first;
}

} // namespace usar::protocol
