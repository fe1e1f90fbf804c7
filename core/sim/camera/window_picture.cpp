#include "core/sim/camera/renderer.h"

#include <algorithm>
#include <array>
#include <optional>

#include "core/base/text.h"

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
    return {.camera_in_map = eye.isometry()};
}

using Views = std::array<const SeenFrom*, most_views>;

/// Each part has the size of the largest picture; parts without a camera are black.
Picture quadView(const CameraScene& scene, const Views& views) {
    int width_px = 0;
    int height_px = 0;
    for (const SeenFrom* const view : views) {
        width_px = std::max(width_px, view ? view->width_px : 0);
        height_px = std::max(height_px, view ? view->height_px : 0);
    }
    Picture whole(2 * width_px, 2 * height_px);
    for (std::size_t i = 0; i < most_views; ++i)
        if (views[i])
            paste(whole, render(scene, *views[i]), i % 2 == 0 ? 0 : width_px, i < 2 ? 0 : height_px);
    return whole;
}

/// Returns nullopt if all cameras that were chosen are gone.
std::optional<Picture> viewportPicture(const CameraScene& scene, const Viewports& wanted) {
    const SeenFrom usual;
    Views views{};
    bool any_chosen = false;
    bool any_there = false;
    for (std::size_t i = 0; i < (wanted.four ? most_views : 1); ++i) {
        any_chosen = any_chosen || wanted.cameras[i];
        views[i] = wanted.cameras[i] ? find(scene, *wanted.cameras[i]) : nullptr;
        any_there = any_there || views[i];
    }
    if (any_chosen && !any_there)
        return std::nullopt;
    if (!any_there)
        return Picture(usual.width_px, usual.height_px); // All parts are switched off.
    return wanted.four ? quadView(scene, views) : render(scene, *views[0]);
}

} // namespace

Picture windowPicture(const CameraScene& scene, const CameraChoice* choice) {
    if (choice)
        if (const SeenFrom* const camera = find(scene, *choice))
            return render(scene, *camera);
    if (scene.viewports)
        if (auto picture = viewportPicture(scene, *scene.viewports))
            return *std::move(picture);
    if (scene.cameras.empty())
        return render(scene, bystander(*scene.still));
    if (scene.cameras.size() == 1)
        return render(scene, scene.cameras.front());
    Views first{};
    for (std::size_t i = 0; i < std::min(scene.cameras.size(), most_views); ++i)
        first[i] = &scene.cameras[i];
    return quadView(scene, first);
}

} // namespace usar::sim
