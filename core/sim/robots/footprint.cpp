#include "core/sim/robots/footprint.h"

#include "core/base/alternatives.h"

namespace usar::sim {

namespace {

Outline outlineOf(const BodyPart& part) {
    const Pose& at = part.part_in_body;
    return std::visit(
        Overloaded{
            [&](const CylinderShape& cylinder) {
                return outlineOfCylinder(at, {2.0 * cylinder.radius_m, 2.0 * cylinder.radius_m, cylinder.height_m});
            },
            [&](const CapsuleShape& capsule) {
                std::vector<Vec2> points_m;
                for (const double end_m : {-capsule.height_m / 2.0, capsule.height_m / 2.0}) {
                    const Vec3 center_m = at * Vec3(0.0, 0.0, end_m);
                    const Outline end = outlineOfSphere(center_m.head<2>(), capsule.radius_m);
                    points_m.insert(points_m.end(), end.begin(), end.end());
                }
                return hullOf(std::move(points_m));
            },
            [&](const BoxShape& box) { return outlineOfBox(at, box.size_m); },
            [&](const SphereShape& sphere) { return outlineOfSphere(at.position_m.head<2>(), sphere.radius_m); }},
        part.shape);
}

} // namespace

std::vector<Outline> footprintOf(const RobotModel& robot) {
    std::vector<Outline> outlines;
    for (const BodyPart& part : robot.whole().parts)
        outlines.push_back(outlineOf(part));
    return outlines;
}

} // namespace usar::sim
