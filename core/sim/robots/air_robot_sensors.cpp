#include "core/sim/robots/air_robot_sensors.h"

#include <array>
#include <cmath>

#include "core/base/text.h"

namespace usar::sim {

namespace {

constexpr std::array sonar_names{"L4", "L3", "L2", "L1", "M0", "R1", "R2", "R3", "R4"};
constexpr double sonar_step_rad = radians(18.0);
constexpr double ring_radius_m = 0.5;
constexpr std::uint64_t streams_per_robot = 64;
constexpr std::uint64_t scanner_stream = 20;
constexpr std::uint64_t ins_stream = 21;

Random streamOf(const AirRobotSensorOptions& options, std::uint64_t sensor) {
    return seeded(options.seed, options.robot_number * streams_per_robot + sensor);
}

std::vector<Sonar> makeSonars(const AirRobotSensorOptions& options) {
    std::vector<Sonar> sonars;
    for (std::size_t i = 0; i < sonar_names.size(); ++i) {
        const double yaw_rad = sonar_step_rad * (4.0 - static_cast<double>(i));
        SonarParameters parameters;
        parameters.name = sonar_names[i];
        parameters.sonar_in_base = {
            {ring_radius_m * std::cos(yaw_rad), ring_radius_m * std::sin(yaw_rad), 0.0}, 0.0, 0.0, yaw_rad};
        if (!options.noise)
            parameters.sigma = 0.0;
        sonars.emplace_back(parameters, streamOf(options, i));
    }
    return sonars;
}

RangeScanner makeScanner(const AirRobotSensorOptions& options) {
    RangeScannerParameters parameters;
    parameters.name = "Scanner1";
    parameters.scanner_in_base = {{0.0, 0.0, -0.1}, 0.0, pi / 2.0, 0.0};
    if (!options.noise)
        parameters.sigma = 0.0;
    return {parameters, streamOf(options, scanner_stream)};
}

Ins makeIns(const AirRobotSensorOptions& options) {
    InsParameters parameters;
    parameters.drifting = options.noise;
    if (!options.noise)
        parameters.sigma = 0.0;
    return {parameters, options.spawn_in_map, streamOf(options, ins_stream)};
}

protocol::Setting setting(std::string key, double number) {
    return {std::move(key), "", number};
}

} // namespace

AirRobotSensors::AirRobotSensors(const AirRobotSensorOptions& options)
    : sonars_(makeSonars(options))
    , scanner_(makeScanner(options))
    , ins_(makeIns(options)) {
    describe(options.scan_interval);
}

void AirRobotSensors::describe(Seconds scan_interval) {
    const std::string hard = "HARD";
    for (const Sonar& sonar : sonars_) {
        const SonarParameters& p = sonar.parameters();
        items_.push_back(
            {"Sonar",
             {p.name, p.sonar_in_base, hard},
             {setting("MaxRange", p.maximum_m), setting("MinRange", p.minimum_m), setting("BeamAngle", p.beam_rad)}});
    }
    const RangeScannerParameters& p = scanner_.parameters();
    items_.push_back({"RangeScanner",
                      {p.name, p.scanner_in_base, hard},
                      {setting("MaxRange", p.maximum_m),
                       setting("MinRange", p.minimum_m),
                       setting("Resolution", p.resolution_rad),
                       setting("Fov", p.fov_rad),
                       {"Paning", "False", {}},
                       {"Tilting", "False", {}}}});
    const std::vector<protocol::Setting> interval{setting("ScanInterval", scan_interval.count())};
    items_.push_back({"INS", {ins_.parameters().name, Pose{}, hard}, interval});
    items_.push_back({"GroundTruth", {ground_truth_.name(), Pose{}, hard}, interval});
}

void AirRobotSensors::measure(const Pose& base_in_map, Seconds now, bool first, const Rays& rays,
                              std::vector<protocol::InfoMessage>& out) {
    if (!first) {
        const Eigen::Isometry3d isometry = base_in_map.isometry();
        protocol::SonarReadings sonars{now, {}};
        for (Sonar& sonar : sonars_)
            sonars.ranges.push_back(sonar.measure(isometry, rays));
        out.emplace_back(std::move(sonars));
        protocol::RangeScan scan = scanner_.measure(isometry, rays);
        scan.time = now;
        out.emplace_back(std::move(scan));
        out.emplace_back(ins_.measure(base_in_map));
    }
    out.emplace_back(ground_truth_.measure(base_in_map, now));
}

std::vector<const AirRobotSensors::Item*> AirRobotSensors::find(const std::string& type,
                                                                const std::string& name) const {
    std::vector<const Item*> found;
    for (const Item& item : items_)
        if (sameWord(item.type, type) && (name.empty() || sameWord(item.mounted.name, name)))
            found.push_back(&item);
    return found;
}

protocol::GeometryInfo AirRobotSensors::geometry(const std::string& type, const std::string& name) const {
    protocol::GeometryInfo info;
    info.type = type;
    for (const Item* const item : find(type, name)) {
        info.type = item->type;
        info.items.push_back(item->mounted);
    }
    if (info.items.empty())
        info.robot_class = name; // the bare head repeats the name that was asked for
    return info;
}

protocol::ConfigurationInfo AirRobotSensors::configuration(const std::string& type, const std::string& name) const {
    protocol::ConfigurationInfo info;
    info.type = type;
    for (const Item* const item : find(type, name)) {
        info.type = item->type;
        info.items.push_back({item->mounted.name, item->settings});
    }
    if (info.items.empty() && !name.empty())
        info.items.push_back({name, {}});
    return info;
}

bool AirRobotSensors::setIns(const protocol::SetInsPose& wanted, bool at_rest) {
    const std::string& name = ins_.parameters().name;
    return (wanted.sensor_name.empty() || sameWord(wanted.sensor_name, name)) && ins_.set(wanted.base_in_map, at_rest);
}

} // namespace usar::sim
