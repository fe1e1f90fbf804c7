#include "core/sim/camera/renderer.h"

#include <algorithm>
#include <cmath>

#include "core/sim/camera/appearance.h"
#include "core/sim/camera/seen_solids.h"

namespace usar::sim {

namespace {

constexpr double shadows_within_m = 120.0; ///< beyond this, haze hides them
constexpr double shadow_reach_m = 40.0;
constexpr double off_surface_m = 0.02; ///< keeps a surface from shading itself
constexpr double lamp_cosine = 0.82;   ///< cosine of half its cone
constexpr double lamp_reach_m = 7.0;
constexpr float lamp_light = 1.3f;

/// The first thing that a ray meets, in its own color under its own light; the sky if there is none.
struct Sight {
    double distance_m;
    bool something = false;
    Color color;
};

double leftAfter(double distance_m, double visibility_m) {
    return std::exp(-distance_m / visibility_m);
}

class Painter {
public:
    Painter(const CameraScene& scene, const SeenFrom& camera)
        : scene_(scene)
        , still_(*scene.still)
        , look_(still_)
        , eye_(camera)
        , solids_(scene, eye_) {}

    Picture paint() const {
        Picture picture(eye_.width_px(), eye_.height_px());
        for (int y = 0; y < picture.height_px; ++y)
            for (int x = 0; x < picture.width_px; ++x) {
                const Color color =
                    colorAlong(eye_.through(x + 0.5, y + 0.5), x / SeenSolids::tile_px, y / SeenSolids::tile_px);
                for (int channel = 0; channel < 3; ++channel)
                    picture.at(x, y)[channel] =
                        static_cast<std::uint8_t>(std::clamp(color[channel], 0.0f, 1.0f) * 255.0f + 0.5f);
            }
        return picture;
    }

private:
    Color colorAlong(const Ray& ray, int tile_x, int tile_y) const {
        Sight sight = sightAlong(ray, tile_x, tile_y);
        if (still_.world.water)
            sight.color = throughWater(ray, sight);
        return sight.something ? mixed(look_.haze(), sight.color, leftAfter(sight.distance_m, air_visibility_m))
                               : sight.color;
    }

    Sight sightAlong(const Ray& ray, int tile_x, int tile_y) const {
        const RayHit hit = still_.caster.look(ray.origin_m, ray.direction, farthest_seen_m);
        if (const auto solid = solids_.look(ray, tile_x, tile_y, hit.distance_m)) {
            const Vec3 point_m = ray.origin_m + solid->distance_m * ray.direction;
            return {solid->distance_m, true, lit(solid->color, point_m, solid->normal_in_map, solid->distance_m)};
        }
        if (hit.met == Met::Nothing)
            return {farthest_seen_m, false, look_.sky(ray.direction)};
        const Vec3 point_m = ray.origin_m + hit.distance_m * ray.direction;
        return {hit.distance_m, true, lit(look_.colorOf(hit, point_m), point_m, hit.normal_in_map, hit.distance_m)};
    }

    Color lit(const Color& color, const Vec3& point_m, const Vec3& normal, double distance_m) const {
        const Color light = look_.lightOn(normal, inShadow(point_m, normal, distance_m));
        return scene_.lamps.empty() ? Color(color * light) : Color(color * (light + lampLight(point_m, normal)));
    }

    Color lampLight(const Vec3& point_m, const Vec3& normal) const {
        Color light = Color::Zero();
        for (const SeenLamp& lamp : scene_.lamps) {
            const Vec3 way = point_m - lamp.position_m;
            const double distance_m = way.norm();
            const double cosine = way.dot(lamp.direction) / std::max(distance_m, 1e-6);
            const double facing = -way.dot(normal) / std::max(distance_m, 1e-6);
            if (cosine <= lamp_cosine || facing <= 0.0)
                continue;
            const double far = distance_m / lamp_reach_m;
            const double edge = std::min(1.0, (cosine - lamp_cosine) / 0.06);
            light += lamp_light * static_cast<float>(edge * std::sqrt(facing) / (1.0 + far * far));
        }
        return light;
    }

    bool inShadow(const Vec3& point_m, const Vec3& normal, double distance_m) const {
        if (!look_.hasSun() || distance_m > shadows_within_m || normal.dot(look_.sun()) <= 0.0)
            return false;
        const Ray to_sun{point_m + off_surface_m * normal, look_.sun()};
        return still_.caster.cast(to_sun.origin_m, to_sun.direction, shadow_reach_m) < shadow_reach_m ||
               solids_.blocks(to_sun, shadow_reach_m);
    }

    /// Blends the water's own color over what is below, and adds the sky's reflection on the surface. `sight` then ends
    /// at the surface.
    Color throughWater(const Ray& ray, Sight& sight) const {
        const double surface_m = still_.world.water->surface_z_m;
        const double above_m = ray.origin_m.z() - surface_m;
        const double to_surface_m = ray.direction.z() != 0.0 ? -above_m / ray.direction.z() : no_hit_m;
        const bool crosses = to_surface_m > 0.0 && (to_surface_m < sight.distance_m || !sight.something);
        if (above_m < 0.0) {
            const double wet_m = crosses ? to_surface_m : sight.distance_m;
            const Color seen = mixed(look_.deepWater(), sight.color, leftAfter(wet_m, 2.0 * water_visibility_m));
            sight.distance_m = 0.0;
            sight.something = true; // There is no haze under water.
            return seen;
        }
        if (!crosses)
            return sight.color;
        const double wet_m = sight.something ? sight.distance_m - to_surface_m : no_hit_m;
        const Color below = mixed(look_.deepWater(), sight.color, leftAfter(wet_m, water_visibility_m));
        // Schlick's approximation, for water in air.
        const double mirrored = 0.02 + 0.98 * std::pow(1.0 + ray.direction.z(), 5.0);
        sight.distance_m = to_surface_m;
        sight.something = true;
        return mixed(below, look_.sky({ray.direction.x(), ray.direction.y(), -ray.direction.z()}), mirrored);
    }

    const CameraScene& scene_;
    const StillWorld& still_;
    Appearance look_;
    Eye eye_;
    SeenSolids solids_;
};

} // namespace

Picture render(const CameraScene& scene, const SeenFrom& camera) {
    return Painter(scene, camera).paint();
}

} // namespace usar::sim
