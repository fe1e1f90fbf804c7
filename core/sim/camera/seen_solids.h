// The moving things in a camera's picture, sorted by the part of the picture that they can be seen in.
#pragma once

#include <optional>
#include <vector>

#include "core/sim/camera/camera_scene.h"
#include "core/sim/ray_shapes.h"

namespace usar::sim {

/// A pinhole camera's rays.
class Eye {
public:
    explicit Eye(const SeenFrom& camera);

    /// Through this point of the picture, in pixels from its top left corner; a pixel's middle is at .5.
    Ray through(double x_px, double y_px) const;
    int width_px() const { return width_px_; }
    int height_px() const { return height_px_; }

private:
    Vec3 position_m_;
    Vec3 ahead_; ///< to the middle of the picture
    Vec3 right_; ///< a pixel to the right, at distance 1
    Vec3 down_;
    int width_px_;
    int height_px_;
};

struct SolidHit {
    double distance_m;
    Vec3 normal_in_map;
    Color color;
};

/// What the camera is inside of is not seen: its own housing. `scene` must outlive it.
class SeenSolids {
public:
    static constexpr int tile_px = 16;

    SeenSolids(const CameraScene& scene, const Eye& eye);

    /// Nearer than `nearest_m`, by a ray through this tile.
    std::optional<SolidHit> look(const Ray& ray, int tile_x, int tile_y, double nearest_m) const;
    /// Whether any solid is in the way.
    bool blocks(const Ray& ray, double maximum_m) const;

private:
    std::vector<const SeenSolid*> all_;
    std::vector<std::vector<const SeenSolid*>> tiles_;
    int tile_columns_;
};

} // namespace usar::sim
