#include "core/sim/camera/window_picture.h"

#include <algorithm>

#include "core/base/text.h"
#include "core/sim/camera/renderer.h"

namespace usar::sim {

namespace {

constexpr std::size_t most_views = 4;

const SeenFrom* find(const CameraScene& scene, const CameraChoice& choice) {
    const auto found = std::ranges::find_if(scene.cameras, [&](const SeenFrom& camera) {
        return sameWord(camera.robot, choice.robot) &&
               (choice.camera.empty() || sameWord(camera.camera, choice.camera));
    });
    return found == scene.cameras.end() ? nullptr : &*found;
}

SeenFrom bystander(const StillWorld& still) {
    Pose place{.position_m = {0.0, 0.0, 0.0}};
    if (!still.world.start_poses.empty())
        place = still.world.start_poses.front().pose_in_map;
    const bool room = still.caster.roofed();
    const double back_m = room ? 0.0 : 10.0;
    Pose eye = place;
    eye.roll_rad = 0.0;
    eye.pitch_rad = room ? 0.1 : 0.35;
    eye.position_m -= back_m * Vec3{std::cos(place.yaw_rad), std::sin(place.yaw_rad), 0.0};
    const double ground_m = still.caster.surface_m(eye.position_m.head<2>());
    eye.position_m.z() = std::max(ground_m, place.position_m.z()) + (room ? 1.0 : 4.0);
    SeenFrom view;
    view.camera_in_map = eye.isometry();
    return view;
}

Picture quadView(const CameraScene& scene) {
    const std::size_t count = std::min(scene.cameras.size(), most_views);
    int width_px = 0;
    int height_px = 0;
    for (std::size_t i = 0; i < count; ++i) {
        width_px = std::max(width_px, scene.cameras[i].width_px);
        height_px = std::max(height_px, scene.cameras[i].height_px);
    }
    Picture whole(2 * width_px, 2 * height_px);
    for (std::size_t i = 0; i < count; ++i)
        paste(whole, render(scene, scene.cameras[i]), i % 2 == 0 ? 0 : width_px, i < 2 ? 0 : height_px);
    return whole;
}

} // namespace

Picture windowPicture(const CameraScene& scene, const CameraChoice* choice) {
    if (choice)
        if (const SeenFrom* const camera = find(scene, *choice))
            return render(scene, *camera);
    if (scene.cameras.empty())
        return render(scene, bystander(*scene.still));
    return scene.cameras.size() == 1 ? render(scene, scene.cameras.front()) : quadView(scene);
}

} // namespace usar::sim
