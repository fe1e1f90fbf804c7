#include "core/sim/camera/scene_capture.h"

#include <array>
#include <cmath>
#include <variant>

#include "core/base/alternatives.h"
#include "core/base/text.h"
#include "core/sim/robots/robot_model.h"

namespace usar::sim {

namespace {

/// Palette of Okabe and Ito: can be told apart with the common color deficiencies, and no ground or tree has these
/// colors.
const std::array robot_colors{Color{0.90f, 0.62f, 0.00f}, Color{0.34f, 0.71f, 0.91f}, Color{0.94f, 0.89f, 0.26f},
                              Color{0.80f, 0.47f, 0.65f}, Color{0.84f, 0.37f, 0.00f}, Color{0.00f, 0.45f, 0.70f}};
const Color running_gear{0.16f, 0.16f, 0.18f};
const Color skin{0.85f, 0.63f, 0.50f};
const Color clothes{0.62f, 0.16f, 0.20f};
const Color tag_color{0.95f, 0.95f, 0.98f};
constexpr double tag_radius_m = 0.05;

Color colorOf(const SceneObject& object) {
    struct Named {
        std::string_view name;
        Color color;
    };
    static const std::array known{Named{"Box", {0.70f, 0.52f, 0.32f}},    Named{"Crate", {0.55f, 0.38f, 0.20f}},
                                  Named{"Brick", {0.62f, 0.26f, 0.18f}},  Named{"Ball", {0.90f, 0.80f, 0.15f}},
                                  Named{"Barrel", {0.15f, 0.32f, 0.62f}}, Named{"SoccerBall", {0.95f, 0.45f, 0.10f}}};
    const std::string_view bare_name = withoutPackage(object.class_name);
    for (const Named& one : known)
        if (sameWord(one.name, bare_name))
            return one.color;
    return {0.78f, 0.78f, 0.80f};
}

/// How a part of a victim looks; in the order of VictimPartKind.
struct PartLook {
    double radius_m;
    bool bare; ///< skin, not clothes
};
constexpr std::array part_looks{PartLook{0.11, true},  PartLook{0.09, false}, PartLook{0.06, true},
                                PartLook{0.17, false}, PartLook{0.17, false}, PartLook{0.09, false},
                                PartLook{0.06, true}};

void addParts(CameraScene& seen, const BodyDescription& body, const BodyState& state, const Color& color) {
    const Eigen::Isometry3d body_in_map = Eigen::Translation3d(state.position_m) * state.rotation;
    for (const BodyPart& part : body.parts)
        seen.solids.push_back(seenSolid(part.shape, body_in_map * part.part_in_body.isometry(), color));
}

Eigen::Isometry3d shiftedTo(const Vec3& position_m) {
    return Eigen::Isometry3d(Eigen::Translation3d(position_m));
}

} // namespace

SeenSolid seenSolid(const Shape& shape, const Eigen::Isometry3d& solid_in_map, const Color& color) {
    const Overloaded radius{[](const CylinderShape& rod) { return std::hypot(rod.radius_m, rod.height_m / 2.0); },
                            [](const CapsuleShape& rod) { return rod.radius_m + rod.height_m / 2.0; },
                            [](const BoxShape& box) { return box.size_m.norm() / 2.0; },
                            [](const SphereShape& ball) { return ball.radius_m; }};
    return {shape, solid_in_map.translation(), solid_in_map.linear(), std::visit(radius, shape), color};
}

void addRobot(CameraScene& seen, const Robot& robot, const std::string& name, std::uint32_t number) {
    const RobotBody& body = robot.body();
    const RobotModel& model = body.model();
    addParts(seen, model.body.base, body.physics().state(body.id()), robot_colors[number % robot_colors.size()]);
    for (std::size_t i = 0; i < model.body.links.size(); ++i)
        addParts(seen, model.body.links[i].body, body.physics().state(body.id(), i), running_gear);
    const Eigen::Isometry3d base_in_map = body.link_in_map(-1);
    if (robot.lightOn())
        seen.lamps.push_back(
            {base_in_map * Vec3(model.dimensions_m.x() / 2.0, 0.0, 0.1), base_in_map.linear() * Vec3::UnitX()});
    for (SeenFrom& camera : robot.cameras()) {
        camera.robot = name;
        seen.cameras.push_back(std::move(camera));
    }
}

void addObjects(CameraScene& seen, const Scene& scene) {
    for (const SceneObject& object : scene.objects)
        for (const BodyPart& part : object.parts)
            seen.solids.push_back(
                seenSolid(part.shape, object.body_in_map.isometry() * part.part_in_body.isometry(), colorOf(object)));
}

void addMarks(CameraScene& seen, const World& world) {
    for (const Victim& victim : world.victims)
        for (const VictimPart& part : victim.parts) {
            const PartLook& look = part_looks.at(static_cast<std::size_t>(part.kind));
            seen.solids.push_back(
                seenSolid(SphereShape{look.radius_m}, shiftedTo(part.position_in_map_m), look.bare ? skin : clothes));
        }
    for (const RfidTag& tag : world.rfid_tags)
        seen.solids.push_back(seenSolid(SphereShape{tag_radius_m}, shiftedTo(tag.position_in_map_m), tag_color));
}

} // namespace usar::sim
