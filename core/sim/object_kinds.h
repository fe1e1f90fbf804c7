// The kinds of things that a world controller can make.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/sim/world.h"

namespace usar::sim {

enum class ObjectShape { Box, Sphere, Cylinder };

/// Sizes, masses and how they roll; figures are ours, for no source tells the game's.
struct ObjectKind {
    std::string_view name; ///< its class on the wire, without package
    ObjectShape shape = ObjectShape::Box;
    Vec3 size_m = Vec3::Zero(); ///< at a scale of 1
    double density_kg_m3 = 0.0;
    double friction = 0.0;
    double restitution = 0.0;
    double rolling_m = 0.0;
    bool conveyor = false; ///< stands still, and its top carries what lies on it along its x axis
};

std::span<const ObjectKind> objectKinds();
/// In any case, with or without package; nullptr for other words.
const ObjectKind* findObjectKind(std::string_view class_name);
/// "Box, Crate, …": for sentences.
std::string objectKindNames();

BodyDescription bodyOf(const ObjectKind& kind, const Vec3& scale);
/// The top of a conveyor, a little above and inside its frame, so that only what lies on it is carried.
std::optional<BodyDescription> beltOf(const ObjectKind& kind, const Vec3& scale);

} // namespace usar::sim
