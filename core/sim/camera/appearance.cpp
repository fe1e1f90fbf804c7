#include "core/sim/camera/appearance.h"

#include <algorithm>
#include <cmath>

namespace usar::sim {

namespace {

const Color haze_color{0.76f, 0.81f, 0.86f};
const Color zenith_color{0.29f, 0.50f, 0.80f};
const Color sun_light{0.86f, 0.80f, 0.68f};
const Color sky_light{0.42f, 0.46f, 0.52f};
const Color room_light{1.12f, 1.09f, 1.03f};

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

} // namespace

Appearance::Appearance(const StillWorld& still)
    : world_(still.world)
    , room_(still.caster.roofed())
    , sun_(Vec3{-0.55, -0.45, 0.70}.normalized()) {}

Color Appearance::groundColor(const Vec3& normal, const Vec3& point_m) const {
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

Color Appearance::colorOf(const RayHit& hit, const Vec3& point_m) const {
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

Color Appearance::lightOn(const Vec3& normal, bool shadow) const {
    if (room_) // Lamps overhead. Walls that face different ways differ, so that corners show.
        return room_light * static_cast<float>(0.72 + 0.22 * normal.z() + 0.16 * normal.dot(Vec3{0.8, 0.5, 0.0}));
    const Color from_sky = sky_light * static_cast<float>(0.75 + 0.25 * normal.z());
    const double facing = shadow ? 0.0 : std::max(0.0, normal.dot(sun_));
    return from_sky + sun_light * static_cast<float>(facing);
}

Color Appearance::sky(const Vec3& direction) const {
    const Color blue = mixed(haze_color, zenith_color, std::sqrt(std::clamp(direction.z(), 0.0, 1.0)));
    const double toward_sun = direction.dot(sun_);
    return toward_sun < 0.9 ? blue : mixed(blue, Color{1.0f, 0.97f, 0.88f}, std::pow(toward_sun, 90.0));
}

Color Appearance::haze() const {
    return haze_color;
}

Color Appearance::deepWater() const {
    return {0.05f, 0.20f, 0.27f};
}

} // namespace usar::sim
