// A world as plain values: terrain, plants, boxes, water, start poses. What physics and rays are both built from.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/geometry.h"
#include "core/sim/terrain.h"

namespace usar::sim {

enum class CrownShape { Sphere, Cone };

/// A tree or bush: a vertical trunk cylinder from the ground and a crown. A bush has a trunk height of 0.
struct Plant {
    Vec3 base_in_map_m = Vec3::Zero(); ///< where the trunk meets the ground
    double trunk_radius_m = 0.0;
    double trunk_height_m = 0.0;
    CrownShape crown = CrownShape::Sphere;
    double crown_radius_m = 0.0;
    double crown_height_m = 0.0; ///< cones only; a cone stands on top of the trunk, a sphere is centered there
    bool operator==(const Plant&) const = default;
};

/// A house, wall or shelf.
struct Box {
    Pose center_in_map;
    Vec3 size_m = Vec3::Zero();
    bool operator==(const Box&) const = default;
};

/// A still surface over the whole world; range sensors do not see it.
struct Water {
    double surface_z_m = 0.0;
    double density_kg_m3 = 1000.0;
    bool operator==(const Water&) const = default;
};

struct NamedPose {
    std::string name;
    Pose pose_in_map;
    bool operator==(const NamedPose&) const = default;
};

struct World {
    std::string name; ///< Level on the wire
    Terrain terrain;
    std::vector<Plant> plants;
    std::vector<Box> boxes;
    std::optional<Water> water;
    std::vector<NamedPose> start_poses;
};

} // namespace usar::sim
