// Puts into a camera's scene what is where now. Colors are given here.
#pragma once

#include "core/sim/camera/camera_scene.h"
#include "core/sim/robots/robot.h"
#include "core/sim/scene.h"

namespace usar::sim {

/// Its body, its lamp where it is lit, its cameras. `number` chooses the color.
void addRobot(CameraScene& seen, const Robot& robot, const std::string& name, std::uint32_t number);
void addObjects(CameraScene& seen, const Scene& scene);
/// Victims and tags: no ray of a range sensor meets them.
void addMarks(CameraScene& seen, const World& world);

/// Works out the radius.
SeenSolid seenSolid(const std::variant<CylinderShape, CapsuleShape, BoxShape, SphereShape>& shape,
                    const Eigen::Isometry3d& solid_in_map, const Color& color);

} // namespace usar::sim
