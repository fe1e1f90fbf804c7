// STA as the answer to CONTROL GetSTA: the objects that world controllers have created.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/geometry.h"

namespace usar::protocol {

/// One object. `memory` is the free text that was stored with it when it was created.
struct WorldObject {
    std::string name{};
    std::optional<Vec3> size_m{}; ///< along the object's own axes
    Pose object_in_map{};
    std::string memory{};
    bool operator==(const WorldObject&) const = default;
};

/// All objects of the answer; empty if there are none.
/// On the wire: `STA {Name Box1} {Size 1,1,1} {Location 1,2,3} {Memory hi there} {Rotation 0,0,1.5}`.
struct WorldObjects {
    std::vector<WorldObject> objects{};
    bool operator==(const WorldObjects&) const = default;
};

} // namespace usar::protocol
