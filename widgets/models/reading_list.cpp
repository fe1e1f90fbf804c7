#include "widgets/models/reading_list.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QObject>

#include "core/base/alternatives.h"
#include "widgets/models/figures.h"

namespace usar::widgets {

namespace {

using namespace usar::protocol;

const QString meters = QStringLiteral("m");
const QString degree_sign = QStringLiteral("°");

QString tr(const char* text) {
    return QObject::tr(text);
}

QString named(const std::string& name) {
    return QString::fromStdString(name);
}

/// A row whose bar shows where `value` lies between the limits; without a bar if they are no range.
ReadingRow ranged(const QString& name, double value, double smallest, double largest, const QString& unit,
                  int decimals) {
    ReadingRow row{.name = name, .value = figure(value, decimals), .unit = unit};
    if (!(largest > smallest) || !std::isfinite(value))
        return row;
    row.share = std::clamp((value - smallest) / (largest - smallest), 0.0, 1.0);
    if (smallest < 0.0 && largest > 0.0)
        row.zero_share = -smallest / (largest - smallest);
    return row;
}

ReadingRow flag(const QString& name, bool on, const QString& on_word, const QString& off_word) {
    return {.name = name, .value = on ? on_word : off_word, .mark = on ? RowMark::On : RowMark::Off};
}

/// How far away a place in a sensor's frame is, and to which side.
QString placeText(const Vec3& place_m) {
    const double bearing_deg = degrees(bearingOf(place_m.head<2>()));
    const QString side = std::abs(bearing_deg) < 0.5 ? tr("ahead")
                         : bearing_deg > 0.0         ? tr("%1° left").arg(figure(bearing_deg, 0))
                                                     : tr("%1° right").arg(figure(-bearing_deg, 0));
    return QStringLiteral("%1 m, %2").arg(figure(place_m.norm(), 2), side);
}

std::optional<ReadingList> withRows(ReadingList list) {
    return list.rows.empty() ? std::nullopt : std::optional(std::move(list));
}

ReadingList jointsOf(const RobotState& state) {
    ReadingList list{"joints", tr("joints"),
                     tr("Angle of each joint in degrees, with the server's sign. The server tells no limits: the bars "
                        "reach from −180° to 180°.")};
    for (const JointAngle& joint : state.joints)
        list.rows.push_back(ranged(named(joint.name), degrees(joint.angle_rad), -180.0, 180.0, degree_sign, 1));
    return list;
}

ReadingList linksOf(const PackageState& state, const Fitting& fitting) {
    ReadingList list{"package " + state.name, named(state.name),
                     tr("Each joint of %1: its angle in degrees, or its length in meters. The bar is its range as the "
                        "server tells it; without one, −180° to 180°.")
                         .arg(named(state.name))};
    for (const LinkState& link : state.links) {
        const LinkConfiguration* const limits = fitting.joint(state.name, link.link);
        const QString name = tr("joint %1").arg(link.link);
        const auto limit = [&](const std::optional<double> LinkConfiguration::*which, double otherwise) {
            return limits && limits->*which ? *(limits->*which) : otherwise;
        };
        if (limits && limits->prismatic)
            list.rows.push_back(ranged(name, link.value, limit(&LinkConfiguration::smallest, 0.0),
                                       limit(&LinkConfiguration::largest, 0.0), meters, 3));
        else
            list.rows.push_back(ranged(name, degrees(link.value), degrees(limit(&LinkConfiguration::smallest, -pi)),
                                       degrees(limit(&LinkConfiguration::largest, pi)), degree_sign, 1));
    }
    return list;
}

ReadingList encodersOf(const EncoderReadings& reading, const Fitting& fitting) {
    ReadingList list{"Encoder", tr("encoders"),
                     tr("Count of each encoder since its last reset, and the angle that this is if the server tells "
                        "the size of a tick.")};
    for (const EncoderTicks& one : reading.encoders) {
        ReadingRow row{
            .name = named(one.name), .value = figure(static_cast<double>(one.ticks), 0), .unit = tr("ticks")};
        if (const auto* const told = fitting.settings("Encoder", one.name); told && told->resolution_rad)
            row.value += QStringLiteral("  (%1°)").arg(
                figure(degrees(static_cast<double>(one.ticks) * *told->resolution_rad), 0));
        list.rows.push_back(row);
    }
    return list;
}

ReadingList wheelsOf(const TachometerReading& reading) {
    ReadingList list{"Tachometer", tr("wheels"), tr("Spin of each wheel in radians per second; forward is positive."),
                     true};
    for (std::size_t i = 0; i < reading.speeds_rad_s.size(); ++i)
        list.rows.push_back({.name = tr("wheel %1").arg(i + 1),
                             .value = figure(reading.speeds_rad_s[i], 2),
                             .unit = QStringLiteral("rad/s")});
    return list;
}

ReadingList touchesOf(const TouchReadings& reading) {
    ReadingList list{reading.type, tr("touch"), tr("Whether each bumper, paw or other touch sensor is touched.")};
    for (const NamedTouch& one : reading.touches)
        list.rows.push_back(flag(named(one.name), one.touched, tr("touched"), tr("free")));
    return list;
}

ReadingList rangesOf(const RangeReadings& reading, const Fitting& fitting) {
    ReadingList list{reading.type, tr("ranges"),
                     tr("What each single ray measures, in meters. The bar reaches up to the sensor's range, if the "
                        "server tells it.")};
    for (const NamedRange& one : reading.ranges) {
        if (fitting.looksDown(reading.type, one.name))
            continue;
        const auto* const told = fitting.settings(reading.type, one.name);
        list.rows.push_back(
            ranged(named(one.name), one.range_m, 0.0, told ? told->range_max_m.value_or(0.0) : 0.0, meters, 2));
    }
    return list;
}

ReadingList ballOf(const BallReading& reading) {
    ReadingList list{"Helper", tr("ball"), tr("Whether the camera sees the ball, and how far away it is, in meters."),
                     true};
    const bool seen = reading.visible.value_or(false);
    list.rows.push_back(flag(tr("in sight"), seen, tr("yes"), tr("no")));
    const Vec3 place_m = seen && reading.position ? *reading.position : Vec3::Constant(std::nan(""));
    list.rows.push_back({.name = tr("distance"), .value = figure(place_m.norm(), 2), .unit = meters});
    return list;
}

ReadingList victimsOf(const VictimReading& reading) {
    ReadingList list{"VictSensor", tr("victims"),
                     tr("Parts of people in the sensor's view, with distance in meters and direction in degrees; some "
                        "may be false alarms."),
                     true};
    for (const SeenPart& part : reading.parts)
        list.rows.push_back({.name = named(part.part),
                             .value = part.part_in_sensor_m ? placeText(*part.part_in_sensor_m) : tr("in view"),
                             .mark = RowMark::On});
    if (list.rows.empty())
        list.rows.push_back(flag(tr("in view"), false, {}, tr("nobody")));
    return list;
}

ReadingList taggedVictimsOf(const VictimTagReading& reading) {
    ReadingList list{"VictRFID", tr("victims with tags"),
                     tr("Victims whose radio tag is in reach, with distance in meters and direction in degrees."),
                     true};
    for (const TaggedVictim& one : reading.victims)
        list.rows.push_back({.name = named(one.victim_name.empty() ? one.id : one.victim_name),
                             .value = (one.victim_in_reader_m ? placeText(*one.victim_in_reader_m) : tr("in reach")) +
                                      (one.status.empty() ? QString() : QStringLiteral(" · ") + named(one.status)),
                             .mark = RowMark::On});
    if (list.rows.empty())
        list.rows.push_back(flag(tr("in reach"), false, {}, tr("nobody")));
    return list;
}

ReadingList tagsOf(const RfidReading& reading) {
    ReadingList list{"RFID", tr("radio tags"),
                     tr("Radio tags in reach, with distance in meters, direction in degrees, and what is stored in "
                        "them. Sent only when this changes."),
                     true};
    for (const SeenTag& tag : reading.tags)
        list.rows.push_back({.name = tr("tag %1").arg(tag.id),
                             .value = (tag.tag_in_reader_m ? placeText(*tag.tag_in_reader_m) : tr("in reach")) +
                                      (tag.memory ? QStringLiteral(" · ") + named(*tag.memory) : QString()),
                             .mark = RowMark::On});
    if (list.rows.empty())
        list.rows.push_back(flag(tr("in reach"), false, {}, tr("none")));
    return list;
}

ReadingList gasOf(const GasReading& reading) {
    return {"CO2Sensor",
            tr("gas"),
            tr("Density of each gas as the server sends it; no source tells its unit."),
            false,
            {{.name = named(reading.gas.empty() ? reading.name : reading.gas), .value = figure(reading.density, 2)}}};
}

ReadingList motionOf(const HumanMotionReading& reading) {
    return {"HumanMotion",
            tr("people moving"),
            tr("Probability that a person moves within the sensor's view, in percent, 0 to 100."),
            false,
            {ranged(named(reading.name), 100.0 * reading.probability, 0.0, 100.0, QStringLiteral("%"), 0)}};
}

ReadingList soundOf(const SoundReading& reading) {
    return {"Sound",
            tr("sound"),
            tr("How loud it is at the sensor, in decibels."),
            false,
            {{.name = named(reading.name), .value = figure(reading.loudness_db, 1), .unit = QStringLiteral("dB")}}};
}

ReadingList gpsOf(const GpsReading& reading) {
    ReadingList list{"GPS", tr("GPS"),
                     tr("Latitude (north is positive) and longitude (east is positive) in degrees; a "
                        "fix takes four satellites."),
                     true};
    list.rows.push_back(flag(tr("fix"), reading.fix, tr("yes"), tr("no")));
    if (reading.satellites)
        list.rows.push_back({.name = tr("satellites"), .value = QString::number(*reading.satellites)});
    const auto angle = [&](const QString& name, const std::optional<double>& angle_rad) {
        if (angle_rad)
            list.rows.push_back({.name = name, .value = figure(degrees(*angle_rad), 6), .unit = degree_sign});
    };
    angle(tr("latitude"), reading.latitude_rad);
    angle(tr("longitude"), reading.longitude_rad);
    return list;
}

ReadingList compassOf(const CompassReading& reading) {
    return {"MagneticCompass",
            tr("magnetic compass"),
            tr("The number as the server sends it: it is cut to a whole number and converted twice, so it has no unit "
               "and is no heading."),
            false,
            {{.name = named(reading.name), .value = figure(reading.raw_angle, 0)}}};
}

} // namespace

QString ReadingRow::text() const {
    return unit.isEmpty() ? QStringLiteral("%1 %2").arg(name, value)
                          : QStringLiteral("%1 %2 %3").arg(name, value, unit);
}

bool ReadingList::stale(Seconds now) const {
    return heard.stale(now) && std::ranges::all_of(rows, [now](const ReadingRow& row) { return row.heard.stale(now); });
}

std::optional<ReadingList> readingsOf(const protocol::InfoMessage& message, const Fitting& fitting) {
    using Answer = std::optional<ReadingList>;
    return std::visit(Overloaded{[](const RobotState& state) { return withRows(jointsOf(state)); },
                                 [&](const PackageState& state) { return withRows(linksOf(state, fitting)); },
                                 [&](const EncoderReadings& reading) { return withRows(encodersOf(reading, fitting)); },
                                 [](const TachometerReading& reading) { return withRows(wheelsOf(reading)); },
                                 [](const TouchReadings& reading) { return withRows(touchesOf(reading)); },
                                 [&](const RangeReadings& reading) { return withRows(rangesOf(reading, fitting)); },
                                 [](const BallReading& reading) { return Answer(ballOf(reading)); },
                                 [](const VictimReading& reading) { return Answer(victimsOf(reading)); },
                                 [](const VictimTagReading& reading) { return Answer(taggedVictimsOf(reading)); },
                                 [](const RfidReading& reading) { return Answer(tagsOf(reading)); },
                                 [](const GasReading& reading) { return Answer(gasOf(reading)); },
                                 [](const HumanMotionReading& reading) { return Answer(motionOf(reading)); },
                                 [](const SoundReading& reading) { return Answer(soundOf(reading)); },
                                 [](const GpsReading& reading) { return Answer(gpsOf(reading)); },
                                 [](const CompassReading& reading) { return Answer(compassOf(reading)); },
                                 [](const auto&) { return Answer(); }},
                      message);
}

void take(ReadingList& list, ReadingList news, Seconds at) {
    std::vector<ReadingRow> before = std::exchange(list.rows, {});
    const Heard heard = list.heard;
    if (!news.replaces)
        list.rows = before;
    for (ReadingRow& row : news.rows) {
        const auto same = [&](const ReadingRow& other) { return other.name == row.name; };
        if (const auto known = std::ranges::find_if(before, same); known != before.end())
            row.heard = known->heard;
        row.heard.arrived(at);
        const auto place = std::ranges::find_if(list.rows, same);
        if (place == list.rows.end() || news.replaces)
            list.rows.push_back(std::move(row));
        else
            *place = std::move(row);
    }
    news.rows = std::move(list.rows);
    news.heard = heard;
    news.heard.arrived(at);
    list = std::move(news);
}

} // namespace usar::widgets
