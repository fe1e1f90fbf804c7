// The moving things in a camera's picture, sorted by the tiles of the picture in which they can be seen.
#pragma once

#include <optional>
#include <vector>

#include "core/sim/camera/camera_scene.h"
#include "core/sim/rays/ray_shapes.h"

namespace usar::sim {

/// The rays of a pinhole camera.
class Eye {
public:
    explicit Eye(const SeenFrom& camera);

    /// The ray through this point of the picture, in pixels from its top left corner; a pixel's center is at .5.
    Ray through(double x_px, double y_px) const;
    int width_px() const { return width_px_; }
    int height_px() const { return height_px_; }

private:
    Vec3 position_m_;
    Vec3 ahead_; ///< toward the middle of the picture
    Vec3 right_; ///< one pixel to the right, at distance 1
    Vec3 down_;  ///< one pixel down, likewise
    int width_px_;
    int height_px_;
};

/// The point at which a ray meets a solid.
struct SolidHit {
    double distance_m;
    Vec3 normal_in_map;
    Color color;
};

/// A solid that the camera is inside of is not seen, such as its own housing. `scene` must outlive it.
class SeenSolids {
public:
    /// Width and height of a tile.
    static constexpr int tile_px = 16;

    SeenSolids(const CameraScene& scene, const Eye& eye);

    /// The nearest hit closer than `nearest_m` of a ray through this tile; nullopt if there is none.
    std::optional<SolidHit> look(const Ray& ray, int tile_x, int tile_y, double nearest_m) const;
    /// True if any solid is in the ray's way within `maximum_m`.
    bool blocks(const Ray& ray, double maximum_m) const;

private:
    std::vector<const SeenSolid*> all_;
    std::vector<std::vector<const SeenSolid*>> tiles_; ///< solids by tile, row by row
    int tile_columns_;
};

} // namespace usar::sim
