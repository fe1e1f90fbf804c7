// A camera's picture of a scene, ray by ray.
#pragma once

#include "core/sim/camera/camera_scene.h"
#include "core/sim/camera/picture.h"

namespace usar::sim {

/// One ray a pixel: ground, plants, buildings, robots and objects in sunlight and shade (or a room's light),
/// headlights, water with what lies under it and the sky on it, haze with distance. Free of state: equal scenes give
/// equal pictures, in any thread.
Picture render(const CameraScene& scene, const SeenFrom& camera);

} // namespace usar::sim
