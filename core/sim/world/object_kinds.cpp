#include "core/sim/world/object_kinds.h"

#include <algorithm>
#include <array>

#include "core/base/text.h"
#include "core/sim/robots/robot_model.h"
#include "core/sim/world/nist_kinds.h"

namespace usar::sim {

namespace {

constexpr double belt_rise_m = 0.01; ///< height of the belt above the frame

const std::array object_kinds{
    ObjectKind{"Box", ObjectShape::Box, {0.5, 0.5, 0.5}, 80.0, 0.6, 0.1, 0.0},
    ObjectKind{"Crate", ObjectShape::Box, {1.0, 1.0, 1.0}, 60.0, 0.6, 0.1, 0.0},
    ObjectKind{"Brick", ObjectShape::Box, {0.24, 0.115, 0.071}, 1800.0, 0.8, 0.1, 0.0},
    ObjectKind{"Ball", ObjectShape::Sphere, {0.22, 0.22, 0.22}, 80.0, 0.5, 0.6, 0.003},
    ObjectKind{"SoccerBall", ObjectShape::Sphere, {0.086, 0.086, 0.086}, 180.0, 0.5, 0.6, 0.002},
    ObjectKind{"Barrel", ObjectShape::Cylinder, {0.6, 0.6, 0.9}, 150.0, 0.6, 0.1, 0.002},
    ObjectKind{"Cylinder", ObjectShape::Cylinder, {0.3, 0.3, 0.5}, 200.0, 0.6, 0.1, 0.002},
    ObjectKind{"Conveyor", ObjectShape::Box, {3.0, 0.8, 0.3}, 500.0, 1.0, 0.0, 0.0, true},
};

void makeBox(BodyDescription& body, const Vec3& size_m, double density_kg_m3) {
    body.parts = {{BoxShape{size_m}, {}}};
    body.mass_kg = density_kg_m3 * size_m.prod();
    body.inertia_kg_m2 = body.mass_kg / 12.0 * (Vec3::Constant(size_m.squaredNorm()) - size_m.cwiseProduct(size_m));
}

void makeSphere(BodyDescription& body, double radius_m, double density_kg_m3) {
    body.parts = {{SphereShape{radius_m}, {}}};
    body.mass_kg = density_kg_m3 * 4.0 / 3.0 * pi * radius_m * radius_m * radius_m;
    body.inertia_kg_m2 = Vec3::Constant(0.4 * body.mass_kg * radius_m * radius_m);
}

void makeCylinder(BodyDescription& body, double radius_m, double height_m, double density_kg_m3) {
    body.parts = {{CylinderShape{radius_m, height_m}, {}}};
    body.mass_kg = density_kg_m3 * pi * radius_m * radius_m * height_m;
    const double across_kg_m2 = body.mass_kg / 12.0 * (3.0 * radius_m * radius_m + height_m * height_m);
    body.inertia_kg_m2 = {across_kg_m2, across_kg_m2, body.mass_kg / 2.0 * radius_m * radius_m};
}

} // namespace

std::span<const ObjectKind> objectKinds() {
    return object_kinds;
}

const ObjectKind* findObjectKind(std::string_view class_name) {
    const std::string_view bare_name = withoutPackage(class_name);
    const auto kind =
        std::ranges::find_if(object_kinds, [&](const ObjectKind& one) { return sameWord(one.name, bare_name); });
    return kind == object_kinds.end() ? findNistKind(bare_name) : &*kind;
}

std::string objectKindNames() {
    return listOf(object_kinds, &ObjectKind::name) + ", and NIST's " + listOf(nistKinds(), &ObjectKind::name);
}

BodyDescription bodyOf(const ObjectKind& kind, const Vec3& scale) {
    const Vec3 size_m = kind.size_m.cwiseProduct(scale);
    BodyDescription body{.friction = kind.friction,
                         .restitution = kind.restitution,
                         .rolling_friction_m = kind.rolling_m,
                         .still = kind.conveyor};
    switch (kind.shape) {
    case ObjectShape::Box:
        makeBox(body, size_m, kind.density_kg_m3);
        break;
    case ObjectShape::Sphere:
        makeSphere(body, size_m.x() / 2.0, kind.density_kg_m3);
        break;
    case ObjectShape::Cylinder:
        makeCylinder(body, size_m.x() / 2.0, size_m.z(), kind.density_kg_m3);
        break;
    }
    if (kind.conveyor) {
        const double rise_m = std::min(belt_rise_m, 0.2 * size_m.z());
        body.parts = {{BoxShape{size_m - Vec3(0.0, 0.0, rise_m)}, {Vec3(0.0, 0.0, -rise_m / 2.0)}}};
    }
    return body;
}

std::optional<BodyDescription> beltOf(const ObjectKind& kind, const Vec3& scale) {
    if (!kind.conveyor)
        return std::nullopt;
    const Vec3 size_m = kind.size_m.cwiseProduct(scale);
    const double thick_m = std::min(0.05, size_m.z() / 2.0);
    const Vec3 belt_m(size_m.x() - std::min(0.06, 0.1 * size_m.x()), size_m.y() - std::min(0.02, 0.1 * size_m.y()),
                      thick_m);
    return BodyDescription{.friction = kind.friction,
                           .parts = {{BoxShape{belt_m}, {Vec3(0.0, 0.0, (size_m.z() - thick_m) / 2.0)}}},
                           .still = true};
}

} // namespace usar::sim
