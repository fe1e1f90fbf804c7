#include "core/sim/sensors/range_sensors.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace usar::sim {

namespace {

constexpr double ray_sigma = 0.0007;  // See robots-and-worlds.md 4.1.
constexpr double sonar_sigma = 0.001; // See robots-and-worlds.md 4.2.

} // namespace

double RangeSensor::noisy(double range_m) {
    if (range_m >= maximum_m_)
        return maximum_m_;
    const double factor = sigma_ > 0.0 ? 1.0 + gaussian(random_, sigma_) : 1.0;
    return std::clamp(range_m * factor, minimum_m_, maximum_m_);
}

SonarSensor::SonarSensor(const SensorModel& model, const SensorBirth& birth)
    : RangeSensor(model, birth, 5.0, sonar_sigma)
    , directions_in_link_{Vec3::UnitX()} {
    const bool udk = birth.profile == protocol::Dialect::Udk;
    const int cones = udk ? 0 : static_cast<int>(number("cones", 2.0));
    const int rays_per_cone = static_cast<int>(number("rays_per_cone", 16.0));
    for (int cone = 1; cone <= cones; ++cone) {
        const double off_axis_rad = beam_rad_ / 2.0 * cone / cones;
        for (int ray = 0; ray < rays_per_cone; ++ray) {
            const double around_rad = 2.0 * pi * ray / rays_per_cone;
            directions_in_link_.emplace_back(std::cos(off_axis_rad), std::sin(off_axis_rad) * std::cos(around_rad),
                                             std::sin(off_axis_rad) * std::sin(around_rad));
        }
    }
    for (Vec3& direction : directions_in_link_)
        direction = model.sensor_in_link.rotation() * direction;
}

double SonarSensor::range_m(const Eigen::Isometry3d& link_in_map, const Rays& rays) {
    directions_in_map_.clear();
    for (const Vec3& direction : directions_in_link_)
        directions_in_map_.emplace_back(link_in_map.linear() * direction);
    return noisy(rays.nearestEcho(link_in_map * model().sensor_in_link.position_m, directions_in_map_, maximum_m_));
}

void SonarSensor::measure(const SensorView& view, std::vector<protocol::InfoMessage>& out) {
    auto& line = lineIn<protocol::SonarReadings>(out);
    line.time = view.now;
    line.ranges.push_back({model().name, range_m(view.body.link_in_map(model().link), view.rays)});
}

std::vector<protocol::Setting> SonarSensor::settings() const {
    return {setting("MaxRange", maximum_m_), setting("MinRange", minimum_m_), setting("BeamAngle", beam_rad_)};
}

RaySensor::RaySensor(const SensorModel& model, const SensorBirth& birth) : RangeSensor(model, birth, 5.0, ray_sigma) {}

void RaySensor::measure(const SensorView& view, std::vector<protocol::InfoMessage>& out) {
    const Eigen::Isometry3d sensor_in_map = this->sensor_in_map(view);
    const double range_m =
        view.rays.cast(sensor_in_map.translation(), sensor_in_map.linear() * Vec3::UnitX(), maximum_m_);
    auto* line = &lineIn<protocol::RangeReadings>(out);
    if (!line->ranges.empty() && line->type != model().type)
        line = &std::get<protocol::RangeReadings>(out.emplace_back(protocol::RangeReadings{}));
    line->time = view.now;
    line->type = model().type;
    line->ranges.push_back({model().name, noisy(range_m)});
}

ScannerSensor::ScannerSensor(const SensorModel& model, const SensorBirth& birth)
    : RangeSensor(model, birth, 20.0, ray_sigma) {
    // The small slack keeps the last beam if the quotient misses a whole number only by rounding.
    const int last = static_cast<int>(std::floor(fov_rad_ / resolution_rad_ + 1e-6));
    for (int beam = 0; beam <= last; ++beam) {
        const double angle_rad = -fov_rad_ / 2.0 + beam * resolution_rad_;
        directions_in_link_.push_back(model.sensor_in_link.rotation() *
                                      Vec3(std::cos(angle_rad), std::sin(angle_rad), 0.0));
    }
}

protocol::RangeScan ScannerSensor::scan(const Eigen::Isometry3d& link_in_map, const Rays& rays) {
    const Vec3 origin_m = link_in_map * model().sensor_in_link.position_m;
    protocol::RangeScan scan{{}, model().name, resolution_rad_, fov_rad_, {}, model().type};
    directions_in_map_.clear();
    for (const Vec3& direction : directions_in_link_)
        directions_in_map_.emplace_back(link_in_map.linear() * direction);
    rays.castEach(origin_m, directions_in_map_, maximum_m_, scan.ranges_m);
    for (double& range_m : scan.ranges_m)
        range_m = noisy(range_m);
    return scan;
}

void ScannerSensor::measure(const SensorView& view, std::vector<protocol::InfoMessage>& out) {
    if (!by_itself_ && !std::exchange(wanted_, false))
        return;
    protocol::RangeScan scan = this->scan(view.body.link_in_map(model().link), view.rays);
    scan.time = view.now;
    out.emplace_back(std::move(scan));
}

std::vector<protocol::Setting> ScannerSensor::settings() const {
    return {setting("MaxRange", maximum_m_), setting("MinRange", minimum_m_), setting("Resolution", resolution_rad_),
            setting("Fov", fov_rad_),        {"Paning", "True", {}},          {"Tilting", "False", {}}};
}

std::optional<protocol::Response> ScannerSensor::set(const protocol::Command& command, bool) {
    if (!std::holds_alternative<protocol::ScanNow>(command))
        return std::nullopt;
    wanted_ = true;
    return answer(true);
}

} // namespace usar::sim
