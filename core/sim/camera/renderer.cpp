#include "core/sim/camera/renderer.h"

#include <algorithm>
#include <cmath>

#include "core/sim/camera/seen_solids.h"

namespace usar::sim {

namespace {

/// Visibility in air: at a given distance, exp(-distance / visibility) of a thing's own color is left.
constexpr double air_visibility_m = 260.0;
/// The same under water.
constexpr double water_visibility_m = 3.0;
/// Nothing is looked for beyond this distance, where a hundredth of its color would be left.
constexpr double farthest_seen_m = 4.6 * air_visibility_m;

/// Color that distant things fade to.
const Color haze_color{0.76f, 0.81f, 0.86f};
const Color zenith_color{0.29f, 0.50f, 0.80f};
/// Color that things fade to under water.
const Color deep_water{0.05f, 0.20f, 0.27f};
const Color sun_light{0.86f, 0.80f, 0.68f};
const Color sky_light{0.42f, 0.46f, 0.52f};
const Color room_light{1.12f, 1.09f, 1.03f};

/// Linear mix: `share` 0 gives `a`, 1 gives `b`.
Color mixed(const Color& a, const Color& b, double share) {
    return a + (b - a) * static_cast<float>(share);
}

/// Pseudorandom value in 0..1, the same for the same cell on every machine.
float speckle(std::int64_t x, std::int64_t y, std::int64_t z = 0) {
    auto mixed_bits = static_cast<std::uint64_t>(x) * 0x9E3779B97F4A7C15u +
                      static_cast<std::uint64_t>(y) * 0xC2B2AE3D27D4EB4Fu +
                      static_cast<std::uint64_t>(z) * 0x165667B19E3779F9u;
    mixed_bits ^= mixed_bits >> 31;
    mixed_bits *= 0xD6E8FEB86659FD93u;
    return static_cast<float>(mixed_bits >> 40) / 16777216.0f;
}

/// Smooth noise over the ground, 0 to 1.
float mottle(const Vec3& point_m, double size_m) {
    const double x = point_m.x() / size_m;
    const double y = point_m.y() / size_m;
    const double x0 = std::floor(x);
    const double y0 = std::floor(y);
    const auto u = static_cast<float>(x - x0);
    const auto v = static_cast<float>(y - y0);
    const auto column = static_cast<std::int64_t>(x0);
    const auto row = static_cast<std::int64_t>(y0);
    const float low = std::lerp(speckle(column, row), speckle(column + 1, row), u);
    const float high = std::lerp(speckle(column, row + 1), speckle(column + 1, row + 1), u);
    return std::lerp(low, high, v);
}

float ramp(double value, double from, double to) {
    return static_cast<float>(std::clamp((value - from) / (to - from), 0.0, 1.0));
}

/// A value in 0..1 for each thing, which its position tells apart from others.
float own(const Vec3& thing_m) {
    return speckle(std::llround(thing_m.x() * 100.0), std::llround(thing_m.y() * 100.0));
}

Color crownColor(const Vec3& plant_m, const Vec3& point_m) {
    const Color leaves =
        mixed(Color{0.16f, 0.33f, 0.13f}, Color{0.36f, 0.47f, 0.17f}, static_cast<double>(own(plant_m)));
    const Vec3 cell = point_m / 0.22;
    return leaves * (0.80f + 0.35f * speckle(std::llround(cell.x()), std::llround(cell.y()), std::llround(cell.z())));
}

/// Daylight under a low sun, or a room with its lamps. Made once per picture; `still` must outlive it.
class Appearance {
public:
    /// A roofed world counts as a room.
    explicit Appearance(const StillWorld& still)
        : world_(still.world)
        , room_(still.caster.roofed())
        , sun_(Vec3{-0.55, -0.45, 0.70}.normalized()) {}

    /// Color of the surface itself, without light.
    Color colorOf(const RayHit& hit, const Vec3& point_m) const {
        switch (hit.met) {
        case Met::Ground:
            return groundColor(hit.normal_in_map, point_m);
        case Met::Crown:
            return crownColor(hit.thing_in_map_m, point_m);
        case Met::Trunk:
            return Color{0.36f, 0.26f, 0.17f};
        case Met::Box:
            return mixed(Color{0.80f, 0.75f, 0.66f}, Color{0.66f, 0.60f, 0.56f},
                         static_cast<double>(own(hit.thing_in_map_m)));
        case Met::Nothing:
            break;
        }
        return haze_color;
    }
    /// Light on a surface with this normal, to be multiplied with its color. The sun contributes only if the surface is
    /// not in `shadow`.
    Color lightOn(const Vec3& normal, bool shadow) const {
        if (room_) // Lamps overhead. Walls that face different ways differ, so that corners show.
            return room_light * static_cast<float>(0.72 + 0.22 * normal.z() + 0.16 * normal.dot(Vec3{0.8, 0.5, 0.0}));
        const Color from_sky = sky_light * static_cast<float>(0.75 + 0.25 * normal.z());
        const double facing = shadow ? 0.0 : std::max(0.0, normal.dot(sun_));
        return from_sky + sun_light * static_cast<float>(facing);
    }
    /// Color of the sky in a direction, which is a unit vector.
    Color sky(const Vec3& direction) const {
        const Color blue = mixed(haze_color, zenith_color, std::sqrt(std::clamp(direction.z(), 0.0, 1.0)));
        const double toward_sun = direction.dot(sun_);
        return toward_sun < 0.9 ? blue : mixed(blue, Color{1.0f, 0.97f, 0.88f}, std::pow(toward_sun, 90.0));
    }
    /// Unit vector toward the sun; only of use if hasSun(), because rooms have none.
    const Vec3& sun() const { return sun_; }
    bool hasSun() const { return !room_; }

private:
    Color groundColor(const Vec3& normal, const Vec3& point_m) const {
        const float grain = 0.86f + 0.14f * mottle(point_m, 0.35) + 0.12f * mottle(point_m, 3.0);
        if (room_)
            return Color{0.58f, 0.54f, 0.48f} * grain;
        const Terrain& ground = world_.terrain;
        const auto low_m = static_cast<double>(ground.minimum_m());
        const double span_m = std::max(30.0, static_cast<double>(ground.maximum_m()) - low_m);
        Color color = mixed(Color{0.34f, 0.46f, 0.20f}, Color{0.50f, 0.45f, 0.29f},
                            static_cast<double>(ramp(point_m.z() - low_m, 0.25 * span_m, 0.85 * span_m)));
        if (world_.water)
            color = mixed(Color{0.77f, 0.70f, 0.51f}, color,
                          static_cast<double>(ramp(point_m.z() - world_.water->surface_z_m, 0.3, 1.5)));
        color = mixed(color, Color{0.46f, 0.43f, 0.39f}, static_cast<double>(ramp(normal.z(), 0.88, 0.70)));
        return color * grain;
    }

    const World& world_;
    bool room_;
    Vec3 sun_;
};

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
        return sight.something ? mixed(haze_color, sight.color, leftAfter(sight.distance_m, air_visibility_m))
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
            const Color seen = mixed(deep_water, sight.color, leftAfter(wet_m, 2.0 * water_visibility_m));
            sight.distance_m = 0.0;
            sight.something = true; // There is no haze under water.
            return seen;
        }
        if (!crosses)
            return sight.color;
        const double wet_m = sight.something ? sight.distance_m - to_surface_m : no_hit_m;
        const Color below = mixed(deep_water, sight.color, leftAfter(wet_m, water_visibility_m));
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
