#include "core/sim/sensors/motion_sensors.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace usar::sim {

namespace {

constexpr int scans_at_rest = 2;
constexpr double still_rad = 1e-3;

Vec3 anglesBetween(const Pose& from, const Pose& to) {
    return {normalizedAngle(to.roll_rad - from.roll_rad), normalizedAngle(to.pitch_rad - from.pitch_rad),
            normalizedAngle(to.yaw_rad - from.yaw_rad)};
}

constexpr double meters_per_degree_north = 111'200.0;
constexpr double meters_per_degree_east = 71'670.0;
constexpr int satellites_in_sky = 12;
constexpr int satellites_for_fix = 4;
constexpr double worst_sigma_m = 0.83; ///< with four satellites
constexpr double best_sigma_m = 0.25;  ///< with all satellites
constexpr double satellite_m = 300.0;  ///< a satellite is hidden by anything within this distance

} // namespace

InsSensor::InsSensor(const SensorModel& model, const SensorBirth& birth)
    : Sensor(model, birth)
    , reports_itself_(birth.profile == protocol::Dialect::Udk && model.link < 0 && model.sensor_in_link != Pose{})
    , estimate_(reported(birth.base_in_map)) {
    if (error("drifting", 1.0) == 0.0)
        return;
    const double precision = number("precision", 1000.0);
    const double position_limit = 0.5 / precision;
    const double rotation_limit = position_limit / precision;
    for (double& bias : position_bias_)
        bias = uniform(random_, -position_limit, position_limit);
    for (double& bias : rotation_bias_)
        bias = uniform(random_, -rotation_limit, rotation_limit);
}

Pose InsSensor::reported(const Pose& base_in_map) const {
    return reports_itself_ ? base_in_map * model().sensor_in_link : base_in_map;
}

const Pose& InsSensor::estimate(const Pose& base_in_map) {
    if (started_) {
        integrate(base_in_map);
    } else if (last_) {
        const bool still = anglesBetween(*last_, base_in_map).cwiseAbs().maxCoeff() < still_rad;
        still_scans_ = still ? still_scans_ + 1 : 0;
        started_ = still_scans_ >= scans_at_rest;
    }
    last_ = base_in_map;
    return estimate_;
}

void InsSensor::integrate(const Pose& base_in_map) {
    const Vec3 turned_rad = anglesBetween(*last_, base_in_map);
    const Vec3 moved_m = base_in_map.position_m - last_->position_m;
    double* const angles_rad[3] = {&estimate_.roll_rad, &estimate_.pitch_rad, &estimate_.yaw_rad};
    for (int axis = 0; axis < 3; ++axis) {
        const double error = rotation_bias_[axis] + gaussian(random_, sigma_);
        *angles_rad[axis] = normalizedAngle(*angles_rad[axis] + turned_rad[axis] * (1.0 + error));
    }
    for (int axis = 0; axis < 3; ++axis) {
        const double error = position_bias_[axis] + gaussian(random_, sigma_);
        estimate_.position_m[axis] += moved_m[axis] + moved_m.norm() * error;
    }
}

bool InsSensor::setEstimate(const Pose& base_in_map, bool at_rest) {
    if (!at_rest)
        return false;
    estimate_ = base_in_map;
    position_bias_ = rotation_bias_ = Vec3::Zero();
    return true;
}

void InsSensor::measure(const SensorView& view, std::vector<protocol::InfoMessage>& out) {
    out.emplace_back(protocol::InsReading{{}, model().name, estimate(reported(view.body.base_in_map()))});
}

std::optional<protocol::Response> InsSensor::set(const protocol::Command& command, bool at_rest) {
    const auto* const wanted = std::get_if<protocol::SetInsPose>(&command);
    return wanted ? std::optional(answer(setEstimate(wanted->base_in_map, at_rest))) : std::nullopt;
}

void GroundTruthSensor::measure(const SensorView& view, std::vector<protocol::InfoMessage>& out) {
    out.emplace_back(protocol::GroundTruthReading{view.now, model().name, view.body.base_in_map()});
}

OdometrySensor::OdometrySensor(const SensorModel& model, const SensorBirth& birth)
    : Sensor(model, birth)
    , left_(linkNamedBy("left", model, birth.robot).value())
    , right_(linkNamedBy("right", model, birth.robot).value()) {}

void OdometrySensor::measure(const SensorView& view, std::vector<protocol::InfoMessage>& out) {
    const double left_rad = view.body.joint(left_).position;
    const double right_rad = view.body.joint(right_).position;
    const double left_m = radius_m_ * (left_rad - std::exchange(last_left_rad_, left_rad));
    const double right_m = radius_m_ * (right_rad - std::exchange(last_right_rad_, right_rad));
    const double turned_rad = (right_m - left_m) / separation_m_;
    const double way_m = (left_m + right_m) / 2.0;
    const double yaw_rad = base_in_start_.yaw_rad + turned_rad / 2.0;
    base_in_start_.position_m += way_m * Vec3(std::cos(yaw_rad), std::sin(yaw_rad), 0.0);
    base_in_start_.yaw_rad = normalizedAngle(base_in_start_.yaw_rad + turned_rad);
    out.emplace_back(protocol::OdometryReading{{}, model().name, base_in_start_});
}

std::vector<protocol::Setting> OdometrySensor::settings() const {
    std::vector<protocol::Setting> settings = Sensor::settings();
    settings.push_back(setting("EncoderResolution", number("resolution", radians(1.0))));
    return settings;
}

EncoderSensor::EncoderSensor(const SensorModel& model, const SensorBirth& birth)
    : Sensor(model, birth)
    , link_(linkNamedBy("joint", model, birth.robot).value()) {}

void EncoderSensor::measure(const SensorView& view, std::vector<protocol::InfoMessage>& out) {
    const double position_rad = view.body.joint(link_).position;
    const double step_rad = position_rad - std::exchange(last_rad_, position_rad);
    counted_rad_ += step_rad * (sigma_ > 0.0 ? 1.0 + gaussian(random_, sigma_) : 1.0);
    lineIn<protocol::EncoderReadings>(out).encoders.push_back(
        {model().name, static_cast<long long>(std::trunc(sign_ * counted_rad_ / resolution_rad_))});
}

TachometerSensor::TachometerSensor(const SensorModel& model, const SensorBirth& birth) : Sensor(model, birth) {
    const DriveModel& drive = birth.robot.drive;
    for (const std::string& joint : drive.joints)
        links_.push_back(birth.robot.linkOnJoint(joint).value_or(0));
    if (drive.kind != "skid")
        return;
    const std::vector<int> sides = links_; // First all the left wheels, then all the right ones.
    for (std::size_t i = 0; i < sides.size(); ++i)
        links_[i] = sides[i / 2 + (i % 2) * (sides.size() / 2)];
}

void TachometerSensor::measure(const SensorView& view, std::vector<protocol::InfoMessage>& out) {
    protocol::TachometerReading reading{view.now, model().name, {}, {}};
    for (const int link : links_) {
        const JointState joint = view.body.joint(link);
        reading.speeds_rad_s.push_back(joint.velocity);
        reading.angles_rad.push_back(joint.position);
    }
    out.emplace_back(std::move(reading));
}

void AccelerationSensor::measure(const SensorView& view, std::vector<protocol::InfoMessage>& out) {
    const Vec3 velocity_m_s = view.body.velocity_in_map_m_s();
    const Vec3 before_m_s = std::exchange(last_velocity_m_s_, velocity_m_s).value_or(velocity_m_s);
    const Seconds before = std::exchange(last_at_, view.now);
    const Seconds passed = view.now > before ? view.now - before : view.tick;
    Vec3 felt_m_s2 = (velocity_m_s - before_m_s) / passed.count();
    if (proper_)
        felt_m_s2.z() += gravity_m_s2;
    felt_m_s2 = sensor_in_map(view).linear().transpose() * felt_m_s2;
    if (sigma_m_s2_ > 0.0)
        for (double& term : felt_m_s2)
            term += gaussian(random_, sigma_m_s2_);
    if (proper_)
        out.emplace_back(protocol::AccelerometerReading{view.now, model().name, felt_m_s2});
    else
        out.emplace_back(protocol::AccelerationReading{view.now, model().name, felt_m_s2});
}

void TouchSensor::measure(const SensorView& view, std::vector<protocol::InfoMessage>& out) {
    passOver(view);
    lineIn<protocol::TouchReadings>(out).touches.push_back({model().name, std::exchange(touched_, false)});
}

/// Spreads the satellites over the sky above 10 degrees by the golden angle.
GpsSensor::GpsSensor(const SensorModel& model, const SensorBirth& birth) : Sensor(model, birth) {
    for (int i = 0; i < satellites_in_sky; ++i) {
        const double elevation_rad = radians(10.0 + 75.0 * i / satellites_in_sky);
        const double azimuth_rad = i * pi * (3.0 - std::sqrt(5.0));
        satellites_.emplace_back(std::cos(elevation_rad) * std::cos(azimuth_rad),
                                 std::cos(elevation_rad) * std::sin(azimuth_rad), std::sin(elevation_rad));
    }
}

void GpsSensor::measure(const SensorView& view, std::vector<protocol::InfoMessage>& out) {
    const Vec3 at_m = sensor_in_map(view).translation();
    const auto seen = std::ranges::count_if(
        satellites_, [&](const Vec3& toward) { return view.rays.cast(at_m, toward, satellite_m) >= satellite_m; });
    protocol::GpsReading reading{.name = model().name, .fix = seen >= satellites_for_fix, .satellites = seen};
    if (reading.fix) {
        const double share = static_cast<double>(seen - satellites_for_fix) / (satellites_in_sky - satellites_for_fix);
        const double sigma_m = makesErrors() ? worst_sigma_m + share * (best_sigma_m - worst_sigma_m) : 0.0;
        const auto error_m = [&] { return sigma_m > 0.0 ? gaussian(random_, sigma_m) : 0.0; };
        // The map's x points north and its y west; the wire's y points east (protocol.md 3).
        reading.latitude_rad =
            radians(view.world.gps_reference.latitude_deg + (at_m.x() + error_m()) / meters_per_degree_north);
        reading.longitude_rad =
            radians(view.world.gps_reference.longitude_deg - (at_m.y() + error_m()) / meters_per_degree_east);
    }
    out.emplace_back(std::move(reading));
}

} // namespace usar::sim
