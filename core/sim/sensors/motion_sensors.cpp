#include "core/sim/sensors/motion_sensors.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/text.h"

namespace usar::sim {

namespace {

InsParameters insOf(const SensorModel& model, const SensorBirth& birth) {
    InsParameters p;
    p.name = model.name;
    p.sigma = birth.noise ? numberOr(model.numbers, "sigma", p.sigma) : 0.0;
    p.precision = numberOr(model.numbers, "precision", p.precision);
    p.drifting = birth.noise && numberOr(model.numbers, "drifting", 1.0) != 0.0;
    return p;
}

/// True for a RESET. The caller has already checked that its type and name fit.
bool isReset(const protocol::Command& command) {
    return std::holds_alternative<protocol::ResetSensor>(command);
}

} // namespace

InsSensor::InsSensor(const SensorModel& model, const SensorBirth& birth)
    : Sensor(model)
    , ins_(insOf(model, birth), birth.base_in_map, birth.random)
    , scan_interval_(birth.scan_interval) {}

void InsSensor::measure(const SensorView& view, std::vector<protocol::InfoMessage>& out) {
    out.emplace_back(ins_.measure(view.body.base_in_map()));
}

std::vector<protocol::Setting> InsSensor::settings() const {
    return {setting("ScanInterval", scan_interval_.count())};
}

std::optional<protocol::Response> InsSensor::set(const protocol::Command& command, bool at_rest) {
    const auto* const wanted = std::get_if<protocol::SetInsPose>(&command);
    return wanted ? std::optional(answer(ins_.set(wanted->base_in_map, at_rest))) : std::nullopt;
}

GroundTruthSensor::GroundTruthSensor(const SensorModel& model, const SensorBirth& birth)
    : Sensor(model)
    , scan_interval_(birth.scan_interval) {}

void GroundTruthSensor::measure(const SensorView& view, std::vector<protocol::InfoMessage>& out) {
    out.emplace_back(protocol::GroundTruthReading{view.now, model().name, view.body.base_in_map()});
}

std::vector<protocol::Setting> GroundTruthSensor::settings() const {
    return {setting("ScanInterval", scan_interval_.count())};
}

OdometrySensor::OdometrySensor(const SensorModel& model, const SensorBirth& birth, int left, int right)
    : Sensor(model)
    , left_(left)
    , right_(right)
    , radius_m_(number("wheel_radius", 0.1))
    , separation_m_(number("wheel_separation", 0.33))
    , scan_interval_(birth.scan_interval) {}

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
    return {setting("ScanInterval", scan_interval_.count()),
            setting("EncoderResolution", number("resolution", radians(1.0)))};
}

std::optional<protocol::Response> OdometrySensor::set(const protocol::Command& command, bool) {
    if (!isReset(command))
        return std::nullopt;
    base_in_start_ = {};
    return answer(true);
}

EncoderSensor::EncoderSensor(const SensorModel& model, const SensorBirth& birth, int link)
    : Sensor(model)
    , joint_(link)
    , resolution_rad_(number("resolution", radians(1.0)))
    , sign_(number("sign", 1.0) < 0.0 ? -1.0 : 1.0)
    , sigma_(birth.noise ? number("sigma", 0.0025) : 0.0)
    , random_(birth.random) {}

void EncoderSensor::measure(const SensorView& view, std::vector<protocol::InfoMessage>& out) {
    const double position_rad = view.body.joint(joint_).position;
    const double step_rad = position_rad - std::exchange(last_rad_, position_rad);
    counted_rad_ += step_rad * (sigma_ > 0.0 ? 1.0 + gaussian(random_, sigma_) : 1.0);
    lineIn<protocol::EncoderReadings>(out).encoders.push_back(
        {model().name, static_cast<long long>(std::trunc(sign_ * counted_rad_ / resolution_rad_))});
}

std::vector<protocol::Setting> EncoderSensor::settings() const {
    return {setting("Resolution", resolution_rad_)};
}

std::optional<protocol::Response> EncoderSensor::set(const protocol::Command& command, bool) {
    if (!isReset(command))
        return std::nullopt;
    counted_rad_ = 0.0;
    return answer(true);
}

TachometerSensor::TachometerSensor(const SensorModel& model, const SensorBirth& birth)
    : Sensor(model)
    , scan_interval_(birth.scan_interval) {
    for (const std::string& joint : birth.robot.drive.joints)
        joints_.push_back(birth.robot.linkOnJoint(joint).value_or(0));
}

void TachometerSensor::measure(const SensorView& view, std::vector<protocol::InfoMessage>& out) {
    protocol::TachometerReading reading{view.now, model().name, {}, {}};
    for (const int joint : joints_) {
        reading.speeds_rad_s.push_back(view.body.joint(joint).velocity);
        reading.angles_rad.push_back(view.body.joint(joint).position);
    }
    out.emplace_back(std::move(reading));
}

std::vector<protocol::Setting> TachometerSensor::settings() const {
    return {setting("ScanInterval", scan_interval_.count())};
}

AccelerationSensor::AccelerationSensor(const SensorModel& model, const SensorBirth& birth, bool proper)
    : Sensor(model)
    , proper_(proper)
    , sigma_m_s2_(birth.noise ? number("sigma", 0.02) : 0.0)
    , random_(birth.random)
    , scan_interval_(birth.scan_interval) {}

void AccelerationSensor::measure(const SensorView& view, std::vector<protocol::InfoMessage>& out) {
    const Vec3 velocity_m_s = view.body.velocity_in_map_m_s();
    const Vec3 before_m_s = std::exchange(last_velocity_m_s_, velocity_m_s).value_or(velocity_m_s);
    Vec3 felt_m_s2 = (velocity_m_s - before_m_s) / view.tick.count();
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

std::vector<protocol::Setting> AccelerationSensor::settings() const {
    return {setting("ScanInterval", scan_interval_.count())};
}

void TouchSensor::measure(const SensorView& view, std::vector<protocol::InfoMessage>& out) {
    lineIn<protocol::TouchReadings>(out).touches.push_back({model().name, view.body.touched(model().link)});
}

std::vector<protocol::Setting> TouchSensor::settings() const {
    return {setting("Diameter", number("diameter", 0.01))};
}

} // namespace usar::sim
