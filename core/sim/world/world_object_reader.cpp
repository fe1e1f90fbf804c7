#include "core/sim/world/world_object_reader.h"

#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <string>

#include <sdf/sdf.hh>

#include "core/sim/world/sdf_fields.h"

namespace usar::sim {

namespace {

struct SurfaceFigures {
    double friction = BodyDescription{}.friction;
    double restitution = 0.0;
    double rolling_friction_m = 0.0;
    bool operator==(const SurfaceFigures&) const = default;
};

/// The number at the end of a path of child elements, or `otherwise` if the path ends early.
double numberAt(sdf::ElementPtr element, std::initializer_list<const char*> path, double otherwise) {
    for (const char* name : path) {
        if (!element->HasElement(name))
            return otherwise;
        element = element->GetElement(name);
    }
    return element->Get<double>();
}

SurfaceFigures surfaceOf(const sdf::Collision& collision) {
    const sdf::ElementPtr element = collision.Element();
    const SurfaceFigures usual;
    return {numberAt(element, {"surface", "friction", "bullet", "friction"}, usual.friction),
            numberAt(element, {"surface", "bounce", "restitution_coefficient"}, usual.restitution),
            numberAt(element, {"surface", "friction", "bullet", "rolling_friction"}, usual.rolling_friction_m)};
}

bool isSound(const SurfaceFigures& surface) {
    return surface.friction >= 0.0 && surface.restitution >= 0.0 && surface.restitution <= 1.0 &&
           surface.rolling_friction_m >= 0.0;
}

/// Reads mass and inertia of a link. Returns the pose of the body's frame in the link's, or what is wrong.
Result<Pose, std::string> readInertial(const sdf::Link& link, BodyDescription& body) {
    const ignition::math::Inertiald& inertial = link.Inertial();
    if (!link.Element()->HasElement("inertial"))
        return tl::unexpected(std::string("needs an inertial with its mass"));
    // Vectors are not compared, because ignition's count as equal within 1e-3.
    if (inertial.MassMatrix().OffDiagonalMoments().SquaredLength() > 0.0)
        return tl::unexpected(std::string("needs its inertia about its main axes: turn the inertial's pose"));
    body.mass_kg = inertial.MassMatrix().Mass();
    body.inertia_kg_m2 = toVec3(inertial.MassMatrix().DiagonalMoments());
    if (!(body.mass_kg > 0.0) || !(body.inertia_kg_m2.minCoeff() > 0.0))
        return tl::unexpected(std::string("needs a mass and an inertia above zero"));
    return toPose(inertial.Pose());
}

/// The shape with sizes above zero, or what is wrong with it.
Result<BodyPart, std::string> readPart(const sdf::Collision& collision) {
    const auto shape = shapeIn(*collision.Geom());
    if (!shape)
        return tl::unexpected(std::string("has a shape that is neither a box, a sphere, a cylinder nor a capsule"));
    if (!(shape->smallest_m > 0.0))
        return tl::unexpected(std::string("has a shape without size"));
    return BodyPart{shape->shape, toPose(collision.RawPose())};
}

} // namespace

Result<WorldObject> readObject(const sdf::Model& model, const std::filesystem::path& file) {
    const auto refuse = [&](const std::string& what, const sdf::ElementPtr& element) {
        return refusal("the object \"" + model.Name() + "\" " + what, file, *element);
    };
    if (model.LinkCount() != 1 || model.ModelCount() != 0)
        return refuse("must be one link; static models may have more", model.Element());
    const sdf::Link& link = *model.LinkByIndex(0);
    WorldObject object{model.Name(), childText(*model.Element(), "usar:class_name").value_or(""), {}, {}};
    const auto center_in_link = readInertial(link, object.body);
    if (!center_in_link)
        return refuse(center_in_link.error(), link.Element());
    if (link.CollisionCount() == 0)
        return refuse("has no collision, so it would fall forever", link.Element());
    const SurfaceFigures surface = surfaceOf(*link.CollisionByIndex(0));
    for (std::uint64_t c = 0; c < link.CollisionCount(); ++c) {
        const sdf::Collision& collision = *link.CollisionByIndex(c);
        auto part = readPart(collision);
        if (!part)
            return refuse(part.error(), collision.Element());
        if (!isSound(surface) || surfaceOf(collision) != surface)
            return refuse("needs one surface for all its collisions, restitution within 0..1, friction from 0 up",
                          collision.Element());
        part->part_in_body = inverse(*center_in_link) * part->part_in_body;
        object.body.parts.push_back(*part);
    }
    object.body.friction = surface.friction;
    object.body.restitution = surface.restitution;
    object.body.rolling_friction_m = surface.rolling_friction_m;
    object.body_in_map = toPose(model.RawPose()) * (toPose(link.RawPose()) * *center_in_link);
    return object;
}

} // namespace usar::sim
