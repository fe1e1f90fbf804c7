// What things look like to a camera: colors of the still world, its light and its air.
#pragma once

#include "core/sim/camera/camera_scene.h"

namespace usar::sim {

/// Of the air: what is left of a thing's own color after so many meters is exp(-distance / visibility).
inline constexpr double air_visibility_m = 260.0;
inline constexpr double water_visibility_m = 3.0;
/// Nothing is looked for beyond it: a hundredth of it would show.
inline constexpr double farthest_seen_m = 4.6 * air_visibility_m;

/// Day under a low sun, or a room with its lamps. Made once a picture.
class Appearance {
public:
    explicit Appearance(const StillWorld& still);

    /// Without light.
    Color colorOf(const RayHit& hit, const Vec3& point_m) const;
    /// What falls on a surface that faces this way; the sun's part of it only where it is not in `shadow`.
    Color lightOn(const Vec3& normal, bool shadow) const;
    Color sky(const Vec3& direction) const;
    Color haze() const;
    Color deepWater() const;
    /// Toward the sun; rooms have none.
    const Vec3& sun() const { return sun_; }
    bool hasSun() const { return !room_; }

private:
    Color groundColor(const Vec3& normal, const Vec3& point_m) const;

    const World& world_;
    bool room_;
    Vec3 sun_;
};

/// `share` 0 gives `a`, 1 gives `b`.
inline Color mixed(const Color& a, const Color& b, double share) {
    return a + (b - a) * static_cast<float>(share);
}

} // namespace usar::sim
