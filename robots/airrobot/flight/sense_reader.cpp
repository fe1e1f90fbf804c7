#include "robots/airrobot/flight/sense_reader.h"

#include <algorithm>
#include <cmath>

#include "core/mapping/hit.h"

namespace usar::airrobot {

namespace {

constexpr Seconds never{1e9};
/// The INS's height is a random walk along the way flown: its standard deviation is 5 % of a step of 0.2 m after one
/// step, and grows with the root of their number (robots-and-worlds.md 4.4). Three of them are allowed for.
constexpr double doubt_per_root_m = 3.0 * 0.05 * 0.447;
constexpr double standing_still_m = 0.03; ///< A shorter step is noise of the protocol.
constexpr std::size_t middle_rays = 10;
constexpr double near_m = 10.0;
/// The looks up of a take-off make the roll drift. At 0.05 rad, beams of 20 m seemed to end a meter above a roof, which
/// a robot then met at full speed (`tst_random_surveys_campaign`, number 161109).
constexpr double doubt_sigmas = 2.0;

SonarEcho echoOf(const SonarMount& mount, double range_m, const Pose& base_in_map) {
    const Pose sonar_in_map = base_in_map * mount.sonar_in_base;
    SonarEcho echo;
    echo.name = mount.name;
    echo.bearing_rad = mount.sonar_in_base.yaw_rad;
    echo.range_m = std::min(range_m, mount.maximum_m);
    echo.maximum_m = mount.maximum_m;
    echo.hit = mapping::isHit(range_m, mount.maximum_m);
    echo.origin_in_map_m = sonar_in_map.position_m;
    echo.center_in_map_m = sonar_in_map * Vec3(echo.range_m, 0.0, 0.0);
    const double spread_m = echo.range_m * std::tan(mount.beam_rad / 2.0);
    echo.low_m = echo.center_in_map_m.z() - spread_m;
    echo.high_m = echo.center_in_map_m.z() + spread_m;
    return echo;
}

/// Fills in where the beams of these ranges end.
void placeBeams(const std::vector<Vec2>& directions, const std::vector<double>& ranges_m, double maximum_m,
                const Pose& from_in_map, PlacedScan& placed) {
    const Eigen::Isometry3d scanner_in_map = from_in_map.isometry();
    placed.hits_in_map_m.reserve(ranges_m.size());
    for (std::size_t i = 0; i < ranges_m.size(); ++i) {
        const double range_m = ranges_m[i];
        const Vec3 along(directions[i].x(), directions[i].y(), 0.0);
        if (!(range_m > 0.0))
            continue;
        const Vec3 end_m = scanner_in_map * (std::min(range_m, maximum_m) * along);
        (mapping::isHit(range_m, maximum_m) ? placed.hits_in_map_m : placed.misses_in_map_m).push_back(end_m);
    }
}

/// Fills in how high the beams of these ranges get at least. A drift of the roll makes a wall far away look much
/// higher, so `from_in_map` has none where it is known. It may still be wrong by `doubt_rad`, which is subtracted.
void measureHeights(const std::vector<Vec2>& directions, const std::vector<double>& ranges_m, double maximum_m,
                    const Pose& from_in_map, double doubt_rad, PlacedScan& placed) {
    const Eigen::Isometry3d scanner_in_map = from_in_map.isometry();
    const Vec3 from_m = scanner_in_map.translation();
    for (std::size_t i = 0; i < ranges_m.size(); ++i) {
        if (!(ranges_m[i] > 0.0))
            continue;
        const Vec3 along(directions[i].x(), directions[i].y(), 0.0);
        const Vec3 end_m = scanner_in_map * (std::min(ranges_m[i], maximum_m) * along);
        const double away_m = (end_m - from_m).head<2>().norm();
        const double share = away_m > near_m ? near_m / away_m : 1.0;
        const double surely_m = end_m.z() - doubt_rad * away_m;
        placed.highest_m = std::max(placed.highest_m, surely_m);
        placed.highest_near_m = std::max(placed.highest_near_m, from_m.z() + share * (surely_m - from_m.z()));
    }
}

/// Returns the mean height of the hits nearest to straight below; nullopt if there are fewer than three. When the robot
/// rolls, these come from other rays than when it is level.
std::optional<double> groundBelow(std::vector<Vec3> hits, const Vec3& base_m) {
    const auto offset = [&](const Vec3& hit) {
        const Vec3 ray = hit - base_m;
        return ray.head<2>().norm() / std::max(0.01, ray.norm());
    };
    std::erase_if(hits, [&](const Vec3& hit) { return offset(hit) > std::sin(radians(25.0)); });
    if (hits.size() < 3)
        return std::nullopt;
    const std::size_t count = std::min(middle_rays, hits.size());
    std::ranges::partial_sort(hits, hits.begin() + static_cast<std::ptrdiff_t>(count), {}, offset);
    double sum_m = 0.0;
    for (std::size_t i = 0; i < count; ++i)
        sum_m += hits[i].z();
    return sum_m / static_cast<double>(count);
}

} // namespace

void SenseReader::forgetMotion() {
    pose_check_.forget();
    sonar_check_.forget();
    history_.clear();
    told_history_.clear();
    course_.insWasSet();
    level_flight_.insWasSet();
    flown_m_ = 0.0;
}

Senses SenseReader::read(Seconds now, LineNumber line, const modules::RobotModules& robot, const SensorLayout& layout,
                         Seconds time_out) {
    Senses senses;
    senses.now = now;
    senses.line = line;
    if (by_truth_)
        readPose(now, robot.sensors.groundTruth());
    else
        readPose(now, robot.sensors.ins());
    senses.base_in_map = base_in_map_;
    senses.level_in_map = by_truth_ ? base_in_map_ : level_flight_.corrected(base_in_map_);
    senses.height_doubt_m = by_truth_ ? 0.0 : doubt_per_root_m * std::sqrt(flown_m_);
    senses.velocity_in_map_m_s = history_.velocity_m_s();
    senses.yaw_rate_rad_s = history_.yawRate_rad_s();
    senses.ins_yaw_rate_rad_s = told_history_.yawRate_rad_s();
    readSonars(senses, robot, layout, time_out);
    readScan(senses, robot, layout);
    if (robot.state.latest())
        senses.robot_battery = robot.state.latest()->battery_left;
    senses.leans_beyond_belief = pose_check_.leanLeapt() && ins_seen_ != now;
    senses.ins_age = ins_seen_ ? now - *ins_seen_ : never;
    senses.scan_age = scan_seen_ ? now - *scan_seen_ : never;
    return senses;
}

template <class Reading>
void SenseReader::readPose(Seconds now, const Reading* reading) {
    if (!reading || reading->line == last_ins_)
        return;
    last_ins_ = reading->line;
    const Pose& told_in_map = reading->value.base_in_map;
    if (!pose_check_.believes(now, told_in_map, {commanded_m_s_.norm(), commanded_climb_m_s_}))
        return;
    ins_seen_ = now;
    const double step_m = (told_in_map.position_m - base_in_map_.position_m).norm();
    flown_m_ += history_.at(now) && step_m > standing_still_m ? step_m : 0.0;
    base_in_map_ = told_in_map;
    if (!by_truth_ && corrects_heading_) {
        course_.update(now, base_in_map_, through_air_m_s_);
        base_in_map_.yaw_rad = normalizedAngle(base_in_map_.yaw_rad + course_.correction_rad());
    }
    history_.add(now, base_in_map_);
    told_history_.add(now, told_in_map);
    level_flight_.take(now, base_in_map_);
}

void SenseReader::readSonars(Senses& senses, const modules::RobotModules& robot, const SensorLayout& layout,
                             Seconds time_out) {
    senses.sonar_age = layout.sonars.empty() ? never : Seconds(0.0);
    sonar_check_.begin(senses.now, ground_m_ && senses.position_m().z() > *ground_m_ + sure_of_walls_m);
    for (const SonarMount& mount : layout.sonars) {
        const auto* reading = robot.sensors.sonar(mount.name);
        const bool number = reading && std::isfinite(reading->value.range_m);
        auto heard = sonars_heard_.find(mount.name);
        if (number && (heard == sonars_heard_.end() || heard->second.line != reading->line)) {
            heard = sonars_heard_.try_emplace(mount.name).first;
            heard->second.line = reading->line;
            const double told_m = reading->value.range_m;
            const bool echo = mapping::isHit(told_m, mount.maximum_m);
            if (const auto range_m = sonar_check_.believed_m(mount.name, told_m, echo, {commanded_m_s_.norm(), 0.0})) {
                heard->second.range_m = *range_m;
                heard->second.at = senses.now;
            }
            if (sonar_check_.glimpsed())
                senses.glimpses.push_back(echoOf(mount, told_m, senses.base_in_map));
        }
        const Seconds age = heard == sonars_heard_.end() ? never : senses.now - heard->second.at;
        senses.sonar_age = std::max(senses.sonar_age, age);
        if (age > time_out)
            senses.silent_sonars.push_back(mount.name);
        else if (number)
            senses.sonars.push_back(echoOf(mount, heard->second.range_m, senses.base_in_map));
    }
}

void SenseReader::readScan(Senses& senses, const modules::RobotModules& robot, const SensorLayout& layout) {
    senses.ground_m = ground_m_;
    const auto* scan = robot.sensors.scan(layout.scanner_name);
    if (!scan || scan->line == last_scan_)
        return;
    last_scan_ = scan->line;
    const std::vector<double> ranges_m = scan_check_.believed(scan->value);
    if (ranges_m.empty())
        return;
    scan_seen_ = senses.now;
    const auto& taken_at = scan->value.time;
    const Pose base_in_map = taken_at ? history_.at(*taken_at).value_or(senses.base_in_map) : senses.base_in_map;
    PlacedScan placed{scan->line, base_in_map * layout.scanner_in_base, base_in_map, {}};
    const protocol::RangeScan& told = scan->value;
    const Pose steady_in_map =
        by_truth_ ? placed.scanner_in_map : level_flight_.corrected(base_in_map) * layout.scanner_in_base;
    placed.level_scanner_in_map = steady_in_map;
    placed.lean_known = by_truth_ || wind_ || level_flight_.calm();
    const std::vector<Vec2>& directions = beam_directions_.of(told.step_rad(), told.fov_rad, ranges_m.size());
    placeBeams(directions, ranges_m, layout.scanner_maximum_m, corrects_lean_ ? steady_in_map : placed.scanner_in_map,
               placed);
    // In wind, the lean is that of the INS, and once it is lost, `lean_known` says so.
    const bool doubts = !by_truth_ && level_flight_.calm();
    const double doubt_rad = doubts ? doubt_sigmas * level_flight_.doubt_rad() : 0.0;
    measureHeights(directions, ranges_m, layout.scanner_maximum_m, steady_in_map, doubt_rad, placed);
    senses.ground_m = ground_m_ = groundBelow(placed.hits_in_map_m, base_in_map.position_m);
    senses.scan = std::move(placed);
}

} // namespace usar::airrobot
