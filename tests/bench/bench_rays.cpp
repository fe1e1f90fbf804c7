// What rays cost in `tall_test`: the belly scanner's fan, the sonars' cones, one look from above; and what it costs to
// make ready for them.
#include <benchmark/benchmark.h>

#include <cmath>
#include <span>
#include <vector>

#include "core/base/random.h"
#include "core/sim/rays/ray_caster.h"
#include "core/sim/worlds/made_worlds.h"
#include "tests/sim/bullet_rays.h"

namespace {

using namespace usar;

struct Bundle {
    Vec3 origin_m;
    std::vector<Vec3> directions;
};

const sim::World& world() {
    static const sim::World made = sim::makeTallTest(1);
    return made;
}

const sim::RayCaster& caster() {
    static const sim::RayCaster made(world());
    return made;
}

/// Places 6 m above ground all over the world, not inside a crown; `directionsAt(yaw)` is the sensor.
template <class Directions>
std::vector<Bundle> bundles(Directions directionsAt) {
    Random random = seeded(1, 0);
    std::vector<Bundle> made;
    while (made.size() < 500) {
        const Vec2 at_m{uniform(random, -110.0, 110.0), uniform(random, -110.0, 110.0)};
        const Vec3 origin_m{at_m.x(), at_m.y(), world().terrain.height_m(at_m) + 6.0};
        if (caster().cast(origin_m, Vec3::UnitX(), 1.0) > 0.0)
            made.push_back({origin_m, directionsAt(uniform(random, -pi, pi))});
    }
    return made;
}

/// 181 beams of 1 degree across the track, the middle one straight down.
std::vector<Vec3> scannerFan(double yaw_rad) {
    std::vector<Vec3> fan;
    for (int k = -90; k <= 90; ++k) {
        const double angle_rad = radians(k);
        fan.emplace_back(-std::sin(yaw_rad) * std::sin(angle_rad), std::cos(yaw_rad) * std::sin(angle_rad),
                         -std::cos(angle_rad));
    }
    return fan;
}

/// Nine sonars, 18 degrees apart, of 9 rays within 7.5 degrees each.
std::vector<Vec3> sonarCones(double yaw_rad) {
    std::vector<Vec3> rays;
    for (int sonar = -4; sonar <= 4; ++sonar) {
        const Eigen::Quaterniond ahead(Eigen::AngleAxisd(yaw_rad + radians(18.0 * sonar), Vec3::UnitZ()));
        for (int k = 0; k <= 8; ++k) {
            const double around_rad = pi * k / 4.0;
            const double off = k == 0 ? 0.0 : std::tan(radians(7.5));
            rays.push_back((ahead * Vec3{1.0, off * std::cos(around_rad), off * std::sin(around_rad)}).normalized());
        }
    }
    return rays;
}

/// The physics engine's own ray test over the same world, but for cones, which it is spared.
const doubles::BulletRays& bullet() {
    static const doubles::BulletRays made(world());
    return made;
}

template <class Caster>
void castBundles(benchmark::State& state, const Caster& caster, const std::vector<Bundle>& all, double maximum_m) {
    std::size_t next = 0;
    for (auto _ : state) {
        const Bundle& bundle = all[next++ % all.size()];
        for (const Vec3& direction : bundle.directions)
            benchmark::DoNotOptimize(caster.cast(bundle.origin_m, direction, maximum_m));
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(all.front().directions.size()));
}

void castScannerFan(benchmark::State& state) {
    castBundles(state, caster(), bundles(scannerFan), 20.0);
}
BENCHMARK(castScannerFan);

void castScannerFanByBullet(benchmark::State& state) {
    castBundles(state, bullet(), bundles(scannerFan), 20.0);
}
BENCHMARK(castScannerFanByBullet);

/// The nearest in each cone, as a sonar wants it: `nearest(origin, directions, maximum)`.
template <class Nearest>
void castCones(benchmark::State& state, Nearest nearest) {
    constexpr std::size_t rays_a_cone = 9;
    const std::vector<Bundle> all = bundles(sonarCones);
    std::size_t next = 0;
    for (auto _ : state) {
        const Bundle& bundle = all[next++ % all.size()];
        const std::span<const Vec3> directions(bundle.directions);
        for (std::size_t first = 0; first < directions.size(); first += rays_a_cone)
            benchmark::DoNotOptimize(nearest(bundle.origin_m, directions.subspan(first, rays_a_cone), 5.0));
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(all.front().directions.size()));
}

void castSonarCones(benchmark::State& state) {
    castCones(state, [](const Vec3& origin_m, std::span<const Vec3> directions, double maximum_m) {
        return caster().castNearest(sim::RayBundle(origin_m, directions), maximum_m);
    });
}
BENCHMARK(castSonarCones);

void castSonarConesByBullet(benchmark::State& state) {
    castCones(state, [](const Vec3& origin_m, std::span<const Vec3> directions, double nearest_m) {
        for (const Vec3& direction : directions)
            nearest_m = bullet().cast(origin_m, direction, nearest_m);
        return nearest_m;
    });
}
BENCHMARK(castSonarConesByBullet);

void lookFromAbove(benchmark::State& state) {
    Random random = seeded(2, 0);
    std::vector<Vec2> points_m;
    for (int i = 0; i < 10000; ++i)
        points_m.emplace_back(uniform(random, -120.0, 120.0), uniform(random, -120.0, 120.0));
    std::size_t next = 0;
    for (auto _ : state)
        benchmark::DoNotOptimize(caster().surface_m(points_m[next++ % points_m.size()]));
    state.SetItemsProcessed(state.iterations());
}
BENCHMARK(lookFromAbove);

void buildCaster(benchmark::State& state) {
    for (auto _ : state)
        benchmark::DoNotOptimize(sim::RayCaster(world()));
}
BENCHMARK(buildCaster)->Unit(benchmark::kMillisecond);

} // namespace
