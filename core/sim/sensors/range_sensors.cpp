#include "core/sim/sensors/range_sensors.h"

#include <utility>

namespace usar::sim {

namespace {

constexpr double scanner_sigma = 0.0007; // See robots-and-worlds.md 4.1.
constexpr double sonar_sigma = 0.001;    // See robots-and-worlds.md 4.2.

double sigmaOf(const SensorModel& model, const SensorBirth& birth, double usual) {
    return birth.noise ? numberOr(model.numbers, "sigma", usual) : 0.0;
}

SonarParameters sonarOf(const SensorModel& model, const SensorBirth& birth) {
    SonarParameters p;
    p.name = model.name;
    p.sonar_in_base = model.sensor_in_link;
    p.beam_rad = numberOr(model.numbers, "beam_angle", p.beam_rad);
    p.minimum_m = numberOr(model.numbers, "min_range", p.minimum_m);
    p.maximum_m = numberOr(model.numbers, "max_range", p.maximum_m);
    p.cones = static_cast<int>(numberOr(model.numbers, "cones", p.cones));
    p.rays_per_cone = static_cast<int>(numberOr(model.numbers, "rays_per_cone", p.rays_per_cone));
    p.sigma = sigmaOf(model, birth, sonar_sigma);
    return p;
}

RangeScannerParameters scannerOf(const SensorModel& model, const SensorBirth& birth) {
    RangeScannerParameters p;
    p.name = model.name;
    p.scanner_in_base = model.sensor_in_link;
    p.resolution_rad = numberOr(model.numbers, "resolution", p.resolution_rad);
    p.fov_rad = numberOr(model.numbers, "fov", p.fov_rad);
    p.minimum_m = numberOr(model.numbers, "min_range", p.minimum_m);
    p.maximum_m = numberOr(model.numbers, "max_range", p.maximum_m);
    p.sigma = sigmaOf(model, birth, scanner_sigma);
    return p;
}

} // namespace

SonarSensor::SonarSensor(const SensorModel& model, const SensorBirth& birth)
    : Sensor(model)
    , sonar_(sonarOf(model, birth), birth.random) {}

void SonarSensor::measure(const SensorView& view, std::vector<protocol::InfoMessage>& out) {
    auto& line = lineIn<protocol::SonarReadings>(out);
    line.time = view.now;
    line.ranges.push_back(sonar_.measure(view.body.link_in_map(model().link), view.rays));
}

std::vector<protocol::Setting> SonarSensor::settings() const {
    const SonarParameters& p = sonar_.parameters();
    return {setting("MaxRange", p.maximum_m), setting("MinRange", p.minimum_m), setting("BeamAngle", p.beam_rad)};
}

RaySensor::RaySensor(const SensorModel& model, const SensorBirth& birth)
    : Sensor(model)
    , minimum_m_(number("min_range", 0.1))
    , maximum_m_(number("max_range", 5.0))
    , noise_(sigmaOf(model, birth, scanner_sigma), birth.random) {}

void RaySensor::measure(const SensorView& view, std::vector<protocol::InfoMessage>& out) {
    const Eigen::Isometry3d sensor_in_map = this->sensor_in_map(view);
    const double range_m =
        view.rays.cast(sensor_in_map.translation(), sensor_in_map.linear() * Vec3::UnitX(), maximum_m_);
    auto* line = &lineIn<protocol::RangeReadings>(out);
    if (!line->ranges.empty() && line->type != model().type) {
        out.emplace_back(protocol::RangeReadings{});
        line = &std::get<protocol::RangeReadings>(out.back());
    }
    line->time = view.now;
    line->type = model().type;
    line->ranges.push_back({model().name, noise_(range_m, minimum_m_, maximum_m_)});
}

std::vector<protocol::Setting> RaySensor::settings() const {
    return {setting("MaxRange", maximum_m_), setting("MinRange", minimum_m_)};
}

ScannerSensor::ScannerSensor(const SensorModel& model, const SensorBirth& birth)
    : Sensor(model)
    , scanner_(scannerOf(model, birth), birth.random)
    , by_itself_(number("auto", 1.0) != 0.0) {}

void ScannerSensor::measure(const SensorView& view, std::vector<protocol::InfoMessage>& out) {
    if (!by_itself_ && !std::exchange(wanted_, false))
        return;
    protocol::RangeScan scan = scanner_.measure(view.body.link_in_map(model().link), view.rays);
    scan.time = view.now;
    scan.type = model().type;
    out.emplace_back(std::move(scan));
}

std::vector<protocol::Setting> ScannerSensor::settings() const {
    const RangeScannerParameters& p = scanner_.parameters();
    return {setting("MaxRange", p.maximum_m), setting("MinRange", p.minimum_m), setting("Resolution", p.resolution_rad),
            setting("Fov", p.fov_rad),        {"Paning", "False", {}},          {"Tilting", "False", {}}};
}

std::optional<protocol::Response> ScannerSensor::set(const protocol::Command& command, bool) {
    if (!std::holds_alternative<protocol::ScanNow>(command))
        return std::nullopt;
    wanted_ = true;
    return answer(true);
}

} // namespace usar::sim
