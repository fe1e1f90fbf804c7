// Appearance of the still world to a camera: colors, light and air.
#pragma once

#include "core/sim/camera/camera_scene.h"

namespace usar::sim {

/// Visibility in air: at a given distance, exp(-distance / visibility) of a thing's own color is left.
inline constexpr double air_visibility_m = 260.0;
/// The same under water.
inline constexpr double water_visibility_m = 3.0;
/// Nothing is looked for beyond this distance, where a hundredth of its color would be left.
inline constexpr double farthest_seen_m = 4.6 * air_visibility_m;

/// Daylight under a low sun, or a room with its lamps. Made once per picture; `still` must outlive it.
class Appearance {
public:
    /// A roofed world counts as a room.
    explicit Appearance(const StillWorld& still);

    /// Color of the surface itself, without light.
    Color colorOf(const RayHit& hit, const Vec3& point_m) const;
    /// Light on a surface with this normal, to be multiplied with its color. The sun contributes only if the surface is
    /// not in `shadow`.
    Color lightOn(const Vec3& normal, bool shadow) const;
    /// Color of the sky in a direction, which is a unit vector.
    Color sky(const Vec3& direction) const;
    /// Color that distant things fade to.
    Color haze() const;
    /// Color that things fade to under water.
    Color deepWater() const;
    /// Unit vector toward the sun; only of use if hasSun(), because rooms have none.
    const Vec3& sun() const { return sun_; }
    bool hasSun() const { return !room_; }

private:
    Color groundColor(const Vec3& normal, const Vec3& point_m) const;

    const World& world_;
    bool room_;
    Vec3 sun_;
};

/// Linear mix: `share` 0 gives `a`, 1 gives `b`.
inline Color mixed(const Color& a, const Color& b, double share) {
    return a + (b - a) * static_cast<float>(share);
}

} // namespace usar::sim
