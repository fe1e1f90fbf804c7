// Renders pictures of a scene, ray by ray: of one camera, or of the whole window.
#pragma once

#include "core/sim/camera/camera_scene.h"
#include "core/sim/camera/picture.h"

namespace usar::sim {

/// One ray per pixel: ground, plants, buildings, robots and objects in sunlight and shade (or a room's light),
/// headlights, water with what is below and the sky's reflection, haze with distance. Stateless: equal scenes give
/// equal pictures, in any thread.
Picture render(const CameraScene& scene, const SeenFrom& camera);

/// The picture that the image server shows: the game's window (protocol.md 6.1). Renders the chosen camera. Without a
/// choice, or if it does not exist: the viewports that a client has set, unless all their cameras are gone. Otherwise
/// the only camera; of several, the first four as in QuadView (top left, top right, bottom left, bottom right); without
/// any camera, the view of a bystander behind the first start pose.
Picture windowPicture(const CameraScene& scene, const CameraChoice* choice = nullptr);

} // namespace usar::sim
