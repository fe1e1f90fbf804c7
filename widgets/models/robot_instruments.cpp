#include "widgets/models/robot_instruments.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <QObject>

#include "core/base/alternatives.h"
#include "core/protocol/fields.h"
#include "core/protocol/usual_values.h"
#include "widgets/models/figures.h"
#include "widgets/models/ranges.h"

namespace usar::widgets {

namespace {

using protocol::VehicleKind;

const std::string sonar_type = "Sonar";

/// Every sensor that sends regularly has done so within this time on the protocol clock.
constexpr Seconds settling{1.0};

const QString height_unit = QStringLiteral("m");
const QString speed_unit = QStringLiteral("m/s");

} // namespace

void RobotInstruments::take(const protocol::InfoLine& line, Seconds now) {
    const std::optional<Seconds> told = protocol::timeOf(line.message);
    if (told)
        clock_ = std::min(*told, now); // A damaged time must not keep a reading fresh.
    const Seconds at = told ? *clock_ : std::min(clock_.value_or(now), now);
    if (!first_heard_ || at < *first_heard_)
        first_heard_ = at;
    fitting_.take(line.message);
    pose_.take(line.message, at);
    std::visit(Overloaded{[&](const protocol::RangeScan& scan) {
                              if (scan_ && scan_->name != scan.name)
                                  return;
                              scan_ = scan;
                              scan_heard_.arrived(at);
                          },
                          [&](const protocol::SonarReadings& reading) { takeSonars(reading, at); },
                          [&](const protocol::RangeReadings& reading) { takeRays(reading.type, reading.ranges, at); },
                          [&](const protocol::AltitudeReading& reading) {
                              altitude_ = reading;
                              altitude_heard_.arrived(at);
                          },
                          [](const auto&) {}},
               line.message);
    if (std::holds_alternative<protocol::GeometryInfo>(line.message))
        dropRaysThatLookDown();
    takeLists(line.message, at);
    ++revision_;
}

void RobotInstruments::takeSonars(const protocol::SonarReadings& reading, Seconds at) {
    for (const protocol::NamedRange& one : reading.ranges) {
        auto& [range_m, heard] = sonars_[one.name];
        range_m = one.range_m;
        heard.arrived(at);
    }
    sonars_heard_.arrived(at);
    takeRays(sonar_type, reading.ranges, at);
}

void RobotInstruments::takeRays(const std::string& type, const std::vector<protocol::NamedRange>& ranges, Seconds at) {
    for (const protocol::NamedRange& one : ranges) {
        if (!fitting_.looksDown(type, one.name))
            continue;
        DownRay& ray = down_rays_[one.name];
        ray.type = type;
        ray.range_m = one.range_m;
        ray.heard.arrived(at);
    }
}

/// GEO may tell only now that a ray which was listed looks down.
void RobotInstruments::dropRaysThatLookDown() {
    for (ReadingList& list : lists_)
        std::erase_if(list.rows,
                      [&](const ReadingRow& row) { return fitting_.looksDown(list.key, row.name.toStdString()); });
    std::erase_if(lists_, [](const ReadingList& list) { return list.rows.empty(); });
}

void RobotInstruments::takeLists(const protocol::InfoMessage& message, Seconds at) {
    std::optional<ReadingList> news = readingsOf(message, fitting_);
    if (!news)
        return;
    auto list = std::ranges::find(lists_, news->key, &ReadingList::key);
    if (list == lists_.end())
        list = lists_.insert(lists_.end(), ReadingList{news->key, {}, {}});
    widgets::take(*list, *std::move(news), at);
}

double RobotInstruments::maximumOf(const std::string& type, const std::string& name, double otherwise_m) const {
    const auto* const told = fitting_.settings(type, name);
    const double maximum_m = told ? told->range_max_m.value_or(otherwise_m) : otherwise_m;
    return maximum_m > 0.0 ? maximum_m : otherwise_m;
}

double RobotInstruments::scanMaximum_m() const {
    return scan_ ? maximumOf(scan_->type, scan_->name, protocol::usual_scanner_maximum_m)
                 : protocol::usual_scanner_maximum_m;
}

bool RobotInstruments::scansGround() const {
    if (scan_ && fitting_.mount(scan_->type, scan_->name))
        return fitting_.looksDown(scan_->type, scan_->name);
    return fitting_.kind() == VehicleKind::Aerial || fitting_.kind() == VehicleKind::Unknown;
}

agent::SonarZones RobotInstruments::sonars(Seconds now) const {
    std::map<std::string, double> ranges_m;
    const bool all_stale = sonars_heard_.stale(now);
    for (const auto& [name, sonar] : sonars_)
        ranges_m[name] = !all_stale && sonar.second.stale(now) ? std::numeric_limits<double>::quiet_NaN() : sonar.first;
    agent::SonarZones zones = zonesOf(ranges_m, protocol::usual_sonar_maximum_m);
    for (agent::SonarZone& zone : zones.zones)
        zone.maximum_m = maximumOf(sonar_type, zone.name, protocol::usual_sonar_maximum_m);
    return zones;
}

SonarRing RobotInstruments::ring(const agent::SonarZones& zones) const {
    SonarRing ring;
    if (const auto& size_m = fitting_.dimensions_m()) {
        ring.length_m = size_m->x();
        ring.width_m = size_m->y();
    }
    for (const agent::SonarZone& zone : zones.zones) {
        const std::optional<Pose> mount = fitting_.mount(sonar_type, zone.name);
        if (!mount || fitting_.looksDown(sonar_type, zone.name) || fitting_.looksDown(sonar_type, zone.name, -1.0))
            continue;
        const auto* const told = fitting_.settings(sonar_type, zone.name);
        ring.cones.push_back({zone.name, mount->position_m.head<2>(), mount->yaw_rad,
                              told ? told->beam_angle_rad.value_or(0.0) / 2.0 : 0.0, zone.range_m, zone.maximum_m,
                              zone.risk});
    }
    return ring;
}

bool RobotInstruments::empty() const {
    return !pose_.attitude(Seconds(0.0)) && !scan_ && sonars_.empty() && down_rays_.empty() && !altitude_ &&
           lists_.empty();
}

bool RobotInstruments::settled(Seconds now) const {
    return first_heard_ && now - *first_heard_ > settling;
}

std::optional<InstrumentFigure> RobotInstruments::clearance(Seconds now) const {
    std::optional<double> range_m;
    double maximum_m = 0.0;
    std::string sensor;
    InstrumentFigure shown{};
    if (scan_ && scansGround()) {
        maximum_m = scanMaximum_m();
        range_m = laserSection(*scan_, maximum_m).clearance_m;
        sensor = scan_->name;
        shown.heard = scan_heard_;
    } else if (!down_rays_.empty()) {
        const auto& [name, ray] = *down_rays_.begin();
        maximum_m = maximumOf(ray.type, name, protocol::usual_scanner_maximum_m);
        if (std::isfinite(ray.range_m) && ray.range_m < maximum_m)
            range_m = ray.range_m;
        sensor = name;
        shown.heard = ray.heard;
    } else {
        return std::nullopt;
    }
    const PoseSource* const attitude = pose_.attitude(now);
    const double upright =
        attitude ? std::cos(attitude->roll_pitch_yaw_rad.x()) * std::cos(attitude->roll_pitch_yaw_rad.y()) : 1.0;
    const bool dives = fitting_.kind() == VehicleKind::Nautic;
    shown.caption = dives ? QObject::tr("to bottom") : QObject::tr("over ground");
    shown.value = figure(range_m ? *range_m * upright : qQNaN(), 2);
    shown.unit = height_unit;
    shown.help =
        (dives ? QObject::tr("Distance from %1 straight down to the bottom, in meters; a dash beyond its range of %2 m")
               : QObject::tr("Height of %1 over what is straight below, in meters; a dash beyond its range of %2 m"))
            .arg(QString::fromStdString(sensor), figure(maximum_m, 0));
    return shown;
}

void RobotInstruments::addHeights(std::vector<InstrumentFigure>& figures, Seconds now) const {
    const PoseSource* const place = pose_.place(now);
    const QString source = place ? QString::fromStdString(place->type) : QString();
    if (place && fitting_.kind() == VehicleKind::Nautic && water_z_m_)
        figures.push_back({QObject::tr("depth"), figure(*water_z_m_ - place->base_in_map_m->z(), 2), height_unit,
                           QObject::tr("Depth below the surface of the water, in meters, by %1").arg(source),
                           place->heard});
    if (altitude_ && altitude_->above_start_m)
        figures.push_back({QObject::tr("over start"), figure(*altitude_->above_start_m, 2), height_unit,
                           QObject::tr("Height over the start, in meters, by the altitude sensor"), altitude_heard_});
    else if (place)
        figures.push_back({QObject::tr("over start"), figure(pose_.aboveStart_m(now).value_or(qQNaN()), 2), height_unit,
                           QObject::tr("Height over the first place that was heard of, in meters, by %1").arg(source),
                           place->heard});
    if (altitude_ && altitude_->above_sea_m)
        figures.push_back({QObject::tr("over sea"), figure(*altitude_->above_sea_m, 1), height_unit,
                           QObject::tr("The altitude sensor's absolute altitude, in meters"), altitude_heard_});
    if (auto below = clearance(now))
        figures.push_back(*std::move(below));
}

void RobotInstruments::addSpeeds(std::vector<InstrumentFigure>& figures, Seconds now) const {
    const PoseSource* const place = pose_.place(now);
    if (!place || fitting_.kind() == VehicleKind::StaticPlatform)
        return;
    const std::optional<Motion> motion = pose_.motion(now);
    const QString source = QString::fromStdString(place->type);
    figures.push_back({QObject::tr("speed"), figure(motion ? motion->over_ground_m_s : qQNaN(), 2), speed_unit,
                       QObject::tr("Speed over ground in meters per second, over the last second, by %1").arg(source),
                       place->heard});
    if (fitting_.kind() != VehicleKind::Ground && fitting_.kind() != VehicleKind::Legged)
        figures.push_back(
            {QObject::tr("climb"), figure(motion ? motion->climb_m_s : qQNaN(), 2), speed_unit,
             QObject::tr("How fast it rises, in meters per second, over the last second, by %1; down is negative")
                 .arg(source),
             place->heard});
}

std::vector<InstrumentFigure> RobotInstruments::figures(Seconds now) const {
    std::vector<InstrumentFigure> figures;
    addHeights(figures, now);
    addSpeeds(figures, now);
    return figures;
}

} // namespace usar::widgets
