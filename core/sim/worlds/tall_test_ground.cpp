#include "core/sim/worlds/tall_test_ground.h"

#include <cmath>
#include <optional>

#include "core/base/random.h"

namespace usar::sim {

namespace {

constexpr double ravine_depth_m = 8.0;
constexpr double ravine_half_width_m = 6.0;
constexpr double pond_depth_m = 4.0;
constexpr double pond_fill_m = 2.6;
constexpr double pond_radius_m = 13.0;

double bell(double distance, double width) {
    return std::exp(-(distance / width) * (distance / width));
}

} // namespace

TallTestGround::TallTestGround(std::uint64_t seed) {
    Random random = seeded(seed, 1);
    hills_.seed = random();
    shift_m_ = {uniform(random, 0.0, 80.0), uniform(random, 0.0, 80.0)};
    bend_rad_ = uniform(random, -pi, pi);
    wiggle_rad_ = uniform(random, -pi, pi);
    chooseStarts();
    choosePond();
    for (const StartPlace& start : starts_)
        start_heights_m_.push_back(unlevelled_m(start.at_m));
}

// Noise is level at its lattice points, one of which is the origin. The shift keeps start places off them.
double TallTestGround::hills_m(const Vec2& point_m) const {
    return hills_.at(point_m + shift_m_);
}

double TallTestGround::ravineLine_m(double x_m) const {
    return -62.0 + 14.0 * std::sin(x_m / 27.0 + bend_rad_) + 6.0 * std::sin(x_m / 11.0 + wiggle_rad_);
}

double TallTestGround::ravineDistance_m(const Vec2& point_m) const {
    const double slope = ravineLine_m(point_m.x() + 0.5) - ravineLine_m(point_m.x() - 0.5);
    return std::abs(point_m.y() - ravineLine_m(point_m.x())) / std::hypot(1.0, slope);
}

double TallTestGround::hillsAndRavine_m(const Vec2& point_m) const {
    return hills_m(point_m) - ravine_depth_m * bell(ravineDistance_m(point_m), ravine_half_width_m);
}

double TallTestGround::unlevelled_m(const Vec2& point_m) const {
    return hillsAndRavine_m(point_m) - pond_depth_m * bell((point_m - pond_m_).norm(), pond_radius_m);
}

double TallTestGround::height_m(const Vec2& point_m) const {
    double height_m = unlevelled_m(point_m);
    for (std::size_t i = 0; i < starts_.size(); ++i) {
        const double level = 1.0 - smoothStep(2.5, open_radius_m, (point_m - starts_[i].at_m).norm());
        height_m = std::lerp(height_m, start_heights_m_[i], level);
    }
    return height_m;
}

void TallTestGround::chooseStarts() {
    const Vec2 ravine_edge_m{32.0, std::round(ravineLine_m(32.0)) + 16.0};
    const Vec2 corner_m{104.0, 104.0};
    const Vec2 top_m = bestOnGrid(100.0, 4.0, [&](const Vec2& at_m) -> std::optional<double> {
        const bool apart = at_m.norm() > 45.0 && (at_m - corner_m).norm() > 30.0 && at_m.y() > -20.0;
        return apart ? std::optional(hills_m(at_m)) : std::nullopt;
    });
    starts_ = {{"PlayerStart", Vec2::Zero(), 0.0},
               {"HillTop", top_m, yawToward(top_m, Vec2::Zero())},
               {"RavineEdge", ravine_edge_m, -pi / 2.0},
               {"FarCorner", corner_m, yawToward(corner_m, Vec2::Zero())}};
}

void TallTestGround::choosePond() {
    pond_m_ = bestOnGrid(96.0, 4.0, [&](const Vec2& at_m) -> std::optional<double> {
        if (ravineDistance_m(at_m) < 35.0)
            return std::nullopt;
        for (const StartPlace& start : starts_)
            if ((at_m - start.at_m).norm() < 45.0)
                return std::nullopt;
        return -hills_m(at_m);
    });
    water_z_m_ = std::round((unlevelled_m(pond_m_) + pond_fill_m) * 100.0) / 100.0;
}

} // namespace usar::sim
