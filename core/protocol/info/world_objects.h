// STA as the answer to CONTROL GetSTA: things that a world controller made.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/geometry.h"

namespace usar::protocol {

struct WorldObject {
    std::string name{};
    std::optional<Vec3> size_m{}; ///< along the object's own axes
    Pose object_in_map{};
    std::string memory{};
    bool operator==(const WorldObject&) const = default;
};

/// Empty when there is none.
struct WorldObjects {
    std::vector<WorldObject> objects{};
    bool operator==(const WorldObjects&) const = default;
};

} // namespace usar::protocol
