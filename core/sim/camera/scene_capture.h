// Adds the current state of things to a camera's scene and chooses their colors.
#pragma once

#include "core/sim/camera/camera_scene.h"
#include "core/sim/physics/scene.h"
#include "core/sim/robots/robot.h"

namespace usar::sim {

/// Adds its body, its lamp if it is lit, and its cameras. `number` chooses the color.
void addRobot(CameraScene& seen, const Robot& robot, const std::string& name, std::uint32_t number);
/// Adds all objects, at the poses of the scene's last refresh.
void addObjects(CameraScene& seen, const Scene& scene);
/// Adds victims and tags, which no ray of a range sensor meets.
void addMarks(CameraScene& seen, const World& world);

/// Makes a solid and computes its radius.
SeenSolid seenSolid(const Shape& shape, const Eigen::Isometry3d& solid_in_map, const Color& color);

} // namespace usar::sim
