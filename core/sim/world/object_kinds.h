// The kinds of objects that a world controller can create.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/sim/world/world.h"

namespace usar::sim {

/// Cylinders stand upright.
enum class ObjectShape { Box, Sphere, Cylinder };

/// Size, density and surface of a kind. The figures are ours, because no source gives the game's.
struct ObjectKind {
    std::string_view name; ///< its class on the wire, without package
    ObjectShape shape = ObjectShape::Box;
    Vec3 size_m = Vec3::Zero(); ///< full extents at a scale of 1
    double density_kg_m3 = 0.0;
    double friction = 0.0;
    double restitution = 0.0;
    double rolling_m = 0.0; ///< rolling resistance torque divided by normal force, m
    bool conveyor = false;  ///< stands still; its top carries what lies on it along its x axis
};

/// All kinds but NIST's (nist_kinds.h), always in the same order: those that a person chooses from.
std::span<const ObjectKind> objectKinds();
/// Finds a kind by its class, NIST's included, in any case, with or without package; nullptr if there is none.
const ObjectKind* findObjectKind(std::string_view class_name);
/// The names of all kinds for messages: "Box, Crate, …".
std::string objectKindNames();

/// The kind's body with its size multiplied by `scale`. A sphere uses only x of it, a cylinder only x and z.
BodyDescription bodyOf(const ObjectKind& kind, const Vec3& scale);
/// The moving top of a conveyor, slightly above and inside its frame, so that only what lies on it is carried; nullopt
/// for other kinds.
std::optional<BodyDescription> beltOf(const ObjectKind& kind, const Vec3& scale);

} // namespace usar::sim
