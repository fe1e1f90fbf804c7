// The objects that NIST's world controller of UDK creates (USARPhysObj.WCCrate …), as kinds of ours.
#pragma once

#include <span>
#include <string_view>

#include "core/sim/world/object_kinds.h"

namespace usar::sim {

/// All of them, each without the variants that differ by number, color or letter alone.
std::span<const ObjectKind> nistKinds();
/// Finds a kind by its bare class name in any case. Crates and pallets that differ by a number of their article, a
/// color or a letter, and have no figures of their own here, are their family's: WCCrateRed is a WCCrate. Returns
/// nullptr if there is none.
const ObjectKind* findNistKind(std::string_view bare_name);

} // namespace usar::sim
