#include "core/sim/world/nist_kinds.h"

#include <algorithm>
#include <array>

#include "core/base/text.h"

namespace usar::sim {

namespace {

constexpr double friction = 0.6;

/// A box of this mass.
ObjectKind boxOf(std::string_view name, const Vec3& size_m, double mass_kg) {
    return {name, ObjectShape::Box, size_m, mass_kg / size_m.prod(), friction, 0.1, 0.0};
}

// The names are those of USARPhysObj in hrnr/robocup-usarsim. Sizes of crates with a number, of WCPallet48x40 and of
// KitTray are there, too, and so are the masses of 18, 1.5, 1 and 0.5 kg. All other figures are ours, because the
// meshes that have them are not public.
const std::array kinds{
    boxOf("WCCrate", {0.40, 0.40, 0.40}, 18.0),
    boxOf("WCCrate101223", {0.273, 0.204, 0.249}, 18.0),
    boxOf("WCCrate107227", {0.480, 0.288, 0.282}, 18.0),
    boxOf("WCCrate109533", {0.399, 0.129, 0.123}, 18.0),
    boxOf("WCCrate109775", {0.435, 0.288, 0.255}, 18.0),
    boxOf("WCCrate11204", {0.300, 0.210, 0.201}, 18.0),
    boxOf("WCCrate16788", {0.480, 0.288, 0.279}, 18.0),
    boxOf("WCCrate89710", {0.399, 0.198, 0.126}, 18.0),
    boxOf("WCPallet", {1.22, 1.016, 0.10}, 18.0),
    boxOf("WCPallet48x40", {1.22, 1.016, 0.10}, 18.0),
    boxOf("WCKivaPallet", {1.0, 1.0, 0.4}, 30.0),
    boxOf("WCBoxSmall", {0.10, 0.10, 0.10}, 0.5),
    boxOf("WCBoxLong", {0.30, 0.10, 0.10}, 1.5),
    boxOf("WCBoxLarge", {0.20, 0.20, 0.20}, 1.0),
    boxOf("WCTray", {0.40, 0.30, 0.05}, 2.0),
    boxOf("WCTrayLarge", {0.60, 0.40, 0.05}, 3.0),
    boxOf("WCTrayLong", {0.60, 0.20, 0.05}, 2.0),
    boxOf("WCTraySmall", {0.30, 0.20, 0.05}, 1.0),
    boxOf("WCKitTray", {0.40, 0.30, 0.03}, 2.0),
    boxOf("WCKitTraySmall", {0.20, 0.15, 0.03}, 1.0),
    boxOf("WCObjectBin", {0.60, 0.40, 0.30}, 10.0),
    boxOf("WCCar", {4.2, 1.75, 1.4}, 1100.0),
    boxOf("WCP3AT", {0.50, 0.46, 0.28}, 11.9),
    boxOf("KitTray", {0.190, 0.114, 0.02}, 1.0),
    boxOf("Part", {0.20, 0.20, 0.20}, 1.0),
    boxOf("PartTray", {0.40, 0.30, 0.05}, 2.0),
};

/// True for what a family's members have after its name: "101223", "Blue", "B" or "BTray".
bool isVariant(std::string_view rest) {
    const auto is = [&](std::string_view word) { return sameWord(rest, word); };
    if (std::ranges::all_of(rest, isDigit))
        return true;
    const bool letter = rest.front() >= 'A' && rest.front() <= 'E';
    return is("Red") || is("Green") || is("Blue") || (letter && (rest.size() == 1 || sameWord(rest.substr(1), "Tray")));
}

bool isFamily(std::string_view name) {
    constexpr std::array families{"WCCrate", "WCPallet48x40", "KitTray", "Part", "PartTray"};
    return std::ranges::find(families, name) != families.end();
}

} // namespace

std::span<const ObjectKind> nistKinds() {
    return kinds;
}

const ObjectKind* findNistKind(std::string_view bare_name) {
    const auto exact =
        std::ranges::find_if(kinds, [&](const ObjectKind& one) { return sameWord(one.name, bare_name); });
    if (exact != kinds.end())
        return &*exact;
    const auto family = std::ranges::find_if(kinds, [&](const ObjectKind& one) {
        return isFamily(one.name) && bare_name.size() > one.name.size() &&
               sameWord(bare_name.substr(0, one.name.size()), one.name) && isVariant(bare_name.substr(one.name.size()));
    });
    return family == kinds.end() ? nullptr : &*family;
}

} // namespace usar::sim
