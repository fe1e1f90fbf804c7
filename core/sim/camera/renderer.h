// Renders a camera's picture of a scene, ray by ray.
#pragma once

#include "core/sim/camera/camera_scene.h"
#include "core/sim/camera/picture.h"

namespace usar::sim {

/// One ray per pixel: ground, plants, buildings, robots and objects in sunlight and shade (or a room's light),
/// headlights, water with what is below and the sky's reflection, haze with distance. Stateless: equal scenes give
/// equal pictures, in any thread.
Picture render(const CameraScene& scene, const SeenFrom& camera);

} // namespace usar::sim
