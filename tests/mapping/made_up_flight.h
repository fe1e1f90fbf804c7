// A flight with a scanner over ground that is a formula, for tests of what corrects maps.
#pragma once

#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include "core/mapping/scan_store.h"

namespace usar::mapping::made_up {

using Ground = std::function<double(double x_m, double y_m)>;

inline double hills(double x_m, double y_m) {
    return std::sin(0.7 * x_m) + std::sin(0.6 * y_m + 0.3) + 0.5 * std::sin(0.25 * (x_m + y_m));
}
inline double plane(double, double) {
    return 0.3;
}

/// How it flies and errs.
struct MadeUpFlight {
    Ground ground_m;
    double walk_share = 0.05; ///< noise of the estimate of each step, as a share of it; 0: no drift
    double noise_m = 0.01;    ///< of a range
    std::uint64_t seed = 1;
    int lanes = 4;
    double lane_m = 30.0;
    double spacing_m = 6.0;
    double height_m = 6.0; ///< over z = 0
    double step_m = 0.2;   ///< from one scan to the next one of a lane, in 0.2 s
    int beams_aside = 30;  ///< on each side of the middle one, over 60 degrees
    bool lands = false;    ///< after the last lane the INS is set
    double creep = 0.0;    ///< meters by which the estimate drifts along y for each meter of the way; needs `sidles`
    bool sidles = false;   ///< It also flies from lane to lane in small steps, instead of in one.
    double yaw_error_rad = 0.0; ///< Every other lane has this error; the rest have its opposite.
};

/// The scans as a session keeps them, and where they really were taken.
struct FlownStrips {
    ScanStore store;
    std::vector<Vec3> true_in_map_m; ///< by scan

    /// Root mean square of the errors of the positions after `error_m` (by scan) is taken away, by axis.
    Vec3 left_m(const std::function<Vec3(const KeptScan&)>& error_m) const {
        Vec3 sum_m2 = Vec3::Zero();
        for (std::size_t i = 0; i < true_in_map_m.size(); ++i) {
            const KeptScan& scan = store.scans()[i];
            sum_m2 += (scan.scanner_in_map.position_m - error_m(scan) - true_in_map_m[i]).cwiseAbs2();
        }
        return (sum_m2 / double(true_in_map_m.size())).cwiseSqrt();
    }
};

/// The range from a place downward at an angle to the left, over ground that is nowhere steeper than the beam.
inline double rangeDown_m(const Ground& ground_m, const Vec3& from_m, double angle_rad, const Vec2& left) {
    double near_m = 0.0, far_m = 20.0;
    const auto above_m = [&](double range_m) {
        const Vec2 at_m = from_m.head<2>() + range_m * std::sin(angle_rad) * left;
        return from_m.z() - range_m * std::cos(angle_rad) - ground_m(at_m.x(), at_m.y());
    };
    if (above_m(far_m) > 0.0)
        return far_m;
    for (int i = 0; i < 16; ++i)
        (above_m((near_m + far_m) / 2.0) > 0.0 ? near_m : far_m) = (near_m + far_m) / 2.0;
    return near_m;
}

/// Back and forth along x with five scans a second over 120 degrees, by default at 1 m/s and of 61 beams. `watch` is
/// called after each scan.
inline void fly(const MadeUpFlight& flight, FlownStrips& flown, const std::function<void()>& watch) {
    std::mt19937_64 random(flight.seed);
    std::normal_distribution<double> gaussian;
    Vec3 drift_m = Vec3::Zero(), last_m(0.0, 0.0, flight.height_m);
    double time_s = 0.0;
    const double between_rad = radians(60.0) / flight.beams_aside;
    const auto estimated = [&](const Vec3& at_m) {
        const double step_m = (at_m - last_m).norm();
        last_m = at_m;
        for (int axis = 0; axis < 3; ++axis)
            drift_m[axis] += flight.walk_share * step_m * gaussian(random);
        drift_m.y() += flight.creep * step_m;
        flown.store.move(Seconds(time_s += 0.2), at_m + drift_m);
    };
    for (int lane = 0; lane < flight.lanes; ++lane) {
        const double sign = lane % 2 == 0 ? 1.0 : -1.0, y_m = lane * flight.spacing_m;
        for (double from_m = y_m - flight.spacing_m; flight.sidles && lane > 0 && from_m < y_m; from_m += 0.2)
            estimated({sign > 0.0 ? 0.0 : flight.lane_m, from_m, flight.height_m});
        for (double along_m = 0.0; along_m < flight.lane_m; along_m += flight.step_m) {
            const Vec3 at_m(sign > 0.0 ? along_m : flight.lane_m - along_m, y_m, flight.height_m);
            estimated(at_m);
            KeptScan scan{.scanner_in_map = {at_m + drift_m, 0.0, pi / 2.0, sign > 0.0 ? 0.0 : pi},
                          .line = {flown.true_in_map_m.size() + 1},
                          .continues = along_m > 0.0,
                          .resolution_rad = between_rad,
                          .fov_rad = radians(120.0)};
            const Eigen::Matrix3d turn = scan.scanner_in_map.rotation().toRotationMatrix();
            for (int k = -flight.beams_aside; k <= flight.beams_aside; ++k) {
                const double angle_rad = k * between_rad;
                const double range_m = rangeDown_m(flight.ground_m, at_m, angle_rad, turn.col(1).head<2>());
                scan.ranges_m.push_back(float(range_m + (range_m < 20.0 ? flight.noise_m * gaussian(random) : 0.0)));
            }
            scan.scanner_in_map.yaw_rad += sign * flight.yaw_error_rad;
            flown.store.keep(std::move(scan));
            flown.true_in_map_m.push_back(at_m);
            watch();
        }
    }
    if (flight.lands)
        flown.store.insWasSet(last_m + drift_m, last_m);
}

inline FlownStrips fly(const MadeUpFlight& flight) {
    FlownStrips flown;
    fly(flight, flown, [] {});
    return flown;
}

} // namespace usar::mapping::made_up
