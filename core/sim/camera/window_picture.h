// What the image server shows: the game's window (usarsim-protocol 6.1).
#pragma once

#include "core/sim/camera/camera_scene.h"
#include "core/sim/camera/picture.h"

namespace usar::sim {

/// The chosen camera's picture. Without a choice, or with one that is not there: the viewports that a client has set,
/// unless all their cameras have gone; else of the only camera; of several the first four as QuadView has them (top
/// left, top right, bottom left, bottom right); with none what somebody sees who stands behind the first start pose.
Picture windowPicture(const CameraScene& scene, const CameraChoice* choice = nullptr);

} // namespace usar::sim
