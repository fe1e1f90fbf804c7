#include "core/sim/sensors/ins.h"

#include <utility>

namespace usar::sim {

namespace {

constexpr int scans_at_rest = 2;
constexpr double still_rad = 1e-3;

Vec3 anglesBetween(const Pose& from, const Pose& to) {
    return {normalizedAngle(to.roll_rad - from.roll_rad), normalizedAngle(to.pitch_rad - from.pitch_rad),
            normalizedAngle(to.yaw_rad - from.yaw_rad)};
}

} // namespace

Ins::Ins(InsParameters parameters, const Pose& spawn_in_map, Random random)
    : parameters_(std::move(parameters))
    , random_(random)
    , estimate_(spawn_in_map) {
    if (!parameters_.drifting)
        return;
    const double position_limit = 0.5 / parameters_.precision;
    const double rotation_limit = position_limit / parameters_.precision;
    for (double& bias : position_bias_)
        bias = uniform(random_, -position_limit, position_limit);
    for (double& bias : rotation_bias_)
        bias = uniform(random_, -rotation_limit, rotation_limit);
}

protocol::InsReading Ins::measure(const Pose& base_in_map) {
    if (started_) {
        integrate(base_in_map);
    } else if (has_last_) {
        const bool still = anglesBetween(last_, base_in_map).cwiseAbs().maxCoeff() < still_rad;
        still_scans_ = still ? still_scans_ + 1 : 0;
        started_ = still_scans_ >= scans_at_rest;
    }
    last_ = base_in_map;
    has_last_ = true;
    return {{}, parameters_.name, estimate_};
}

bool Ins::set(const Pose& base_in_map, bool at_rest) {
    if (!at_rest)
        return false;
    estimate_ = base_in_map;
    position_bias_ = rotation_bias_ = Vec3::Zero();
    return true;
}

void Ins::integrate(const Pose& base_in_map) {
    const Vec3 turned_rad = anglesBetween(last_, base_in_map);
    const Vec3 moved_m = base_in_map.position_m - last_.position_m;
    double* const angles_rad[3] = {&estimate_.roll_rad, &estimate_.pitch_rad, &estimate_.yaw_rad};
    for (int axis = 0; axis < 3; ++axis) {
        const double error = rotation_bias_[axis] + gaussian(random_, parameters_.sigma);
        *angles_rad[axis] = normalizedAngle(*angles_rad[axis] + turned_rad[axis] * (1.0 + error));
    }
    for (int axis = 0; axis < 3; ++axis) {
        const double error = position_bias_[axis] + gaussian(random_, parameters_.sigma);
        estimate_.position_m[axis] += moved_m[axis] + moved_m.norm() * error;
    }
}

} // namespace usar::sim
