#include "widgets/models/reading_list.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QObject>

#include "core/base/alternatives.h"
#include "widgets/models/figures.h"

namespace usar::widgets {

namespace {

const QString meter_unit = QStringLiteral("m");
const QString degree_unit = QStringLiteral("°");

QString nameText(const std::string& name) {
    return QString::fromStdString(name);
}

/// A row whose bar shows where `value` lies between the limits; without a bar if they are no range.
ReadingRow rangedRow(const QString& name, double value, double smallest, double largest, const QString& unit,
                     int decimals) {
    ReadingRow row{.name = name, .value = figure(value, decimals), .unit = unit};
    if (!(largest > smallest) || !std::isfinite(value))
        return row;
    row.share = std::clamp((value - smallest) / (largest - smallest), 0.0, 1.0);
    if (smallest < 0.0 && largest > 0.0)
        row.zero_share = -smallest / (largest - smallest);
    return row;
}

ReadingRow flagRow(const QString& name, bool on, const QString& on_word, const QString& off_word) {
    return {.name = name, .value = on ? on_word : off_word, .mark = on ? RowMark::On : RowMark::Off};
}

/// How far away a place in a sensor's frame is, and to which side.
QString placeText(const Vec3& place_m) {
    const double bearing_deg = degrees(bearingOf(place_m.head<2>()));
    const QString side = std::abs(bearing_deg) < 0.5 ? QObject::tr("ahead")
                         : bearing_deg > 0.0         ? QObject::tr("%1° left").arg(figure(bearing_deg, 0))
                                                     : QObject::tr("%1° right").arg(figure(-bearing_deg, 0));
    return QStringLiteral("%1 m, %2").arg(figure(place_m.norm(), 2), side);
}

std::optional<ReadingList> withRows(ReadingList list) {
    return list.rows.empty() ? std::nullopt : std::optional(std::move(list));
}

ReadingList jointsOf(const protocol::RobotState& state) {
    ReadingList list{
        "joints", QObject::tr("joints"),
        QObject::tr("Angle of each joint in degrees, with the server's sign. The server tells no limits: the bars "
                    "reach from −180° to 180°.")};
    for (const protocol::JointAngle& joint : state.joints)
        list.rows.push_back(rangedRow(nameText(joint.name), degrees(joint.angle_rad), -180.0, 180.0, degree_unit, 1));
    return list;
}

ReadingList linksOf(const protocol::PackageState& state, const Fitting& fitting) {
    ReadingList list{
        "package " + state.name, nameText(state.name),
        QObject::tr("Each joint of %1: its angle in degrees, or its length in meters. The bar is its range as the "
                    "server tells it; without one, −180° to 180°.")
            .arg(nameText(state.name))};
    for (const protocol::LinkState& link : state.links) {
        const protocol::LinkConfiguration* const limits = fitting.joint(state.name, link.link);
        const QString name = QObject::tr("joint %1").arg(link.link);
        const auto limit = [&](const std::optional<double> protocol::LinkConfiguration::*which, double otherwise) {
            return limits && limits->*which ? *(limits->*which) : otherwise;
        };
        if (limits && limits->prismatic)
            list.rows.push_back(rangedRow(name, link.value, limit(&protocol::LinkConfiguration::smallest, 0.0),
                                          limit(&protocol::LinkConfiguration::largest, 0.0), meter_unit, 3));
        else
            list.rows.push_back(rangedRow(name, degrees(link.value),
                                          degrees(limit(&protocol::LinkConfiguration::smallest, -pi)),
                                          degrees(limit(&protocol::LinkConfiguration::largest, pi)), degree_unit, 1));
    }
    return list;
}

ReadingList encodersOf(const protocol::EncoderReadings& reading, const Fitting& fitting) {
    ReadingList list{
        "Encoder", QObject::tr("encoders"),
        QObject::tr("Count of each encoder since its last reset, and the angle that this is if the server tells "
                    "the size of a tick.")};
    for (const protocol::EncoderTicks& one : reading.encoders) {
        ReadingRow row{.name = nameText(one.name),
                       .value = figure(static_cast<double>(one.ticks), 0),
                       .unit = QObject::tr("ticks")};
        if (const auto* const told = fitting.settings("Encoder", one.name); told && told->resolution_rad)
            row.unit += QStringLiteral(" = %1°").arg(
                figure(degrees(static_cast<double>(one.ticks) * *told->resolution_rad), 0));
        list.rows.push_back(row);
    }
    return list;
}

ReadingList wheelsOf(const protocol::TachometerReading& reading) {
    ReadingList list{"Tachometer", QObject::tr("wheels"),
                     QObject::tr("Spin of each wheel in radians per second; forward is positive."), true};
    for (std::size_t i = 0; i < reading.speeds_rad_s.size(); ++i)
        list.rows.push_back({.name = QObject::tr("wheel %1").arg(i + 1),
                             .value = figure(reading.speeds_rad_s[i], 2),
                             .unit = QStringLiteral("rad/s")});
    return list;
}

ReadingList touchesOf(const protocol::TouchReadings& reading) {
    ReadingList list{reading.type, QObject::tr("touch"),
                     QObject::tr("Whether each bumper, paw or other touch sensor is touched.")};
    for (const protocol::NamedTouch& one : reading.touches)
        list.rows.push_back(flagRow(nameText(one.name), one.touched, QObject::tr("touched"), QObject::tr("free")));
    return list;
}

ReadingList rangesOf(const protocol::RangeReadings& reading, const Fitting& fitting) {
    ReadingList list{
        reading.type, QObject::tr("ranges"),
        QObject::tr("What each single ray measures, in meters. The bar reaches up to the sensor's range, if the "
                    "server tells it.")};
    for (const protocol::NamedRange& one : reading.ranges) {
        if (fitting.looksDown(reading.type, one.name))
            continue;
        const auto* const told = fitting.settings(reading.type, one.name);
        list.rows.push_back(rangedRow(nameText(one.name), one.range_m, 0.0,
                                      told ? told->range_max_m.value_or(0.0) : 0.0, meter_unit, 2));
    }
    return list;
}

ReadingList ballOf(const protocol::BallReading& reading) {
    ReadingList list{"Helper", QObject::tr("ball"),
                     QObject::tr("Whether the camera sees the ball, and how far away it is, in meters."), true};
    const bool seen = reading.visible.value_or(false);
    list.rows.push_back(flagRow(QObject::tr("in sight"), seen, QObject::tr("yes"), QObject::tr("no")));
    const Vec3 place_m = seen && reading.position ? *reading.position : Vec3::Constant(std::nan(""));
    list.rows.push_back({.name = QObject::tr("distance"), .value = figure(place_m.norm(), 2), .unit = meter_unit});
    return list;
}

ReadingList victimsOf(const protocol::VictimReading& reading) {
    ReadingList list{
        "VictSensor", QObject::tr("victims"),
        QObject::tr("Parts of people in the sensor's view, with distance in meters and direction in degrees; some "
                    "may be false alarms."),
        true};
    for (const protocol::SeenPart& part : reading.parts)
        list.rows.push_back(
            {.name = nameText(part.part),
             .value = part.part_in_sensor_m ? placeText(*part.part_in_sensor_m) : QObject::tr("in view"),
             .mark = RowMark::On});
    if (list.rows.empty())
        list.rows.push_back(flagRow(QObject::tr("in view"), false, {}, QObject::tr("nobody")));
    return list;
}

ReadingList taggedVictimsOf(const protocol::VictimTagReading& reading) {
    ReadingList list{
        "VictRFID", QObject::tr("victims with tags"),
        QObject::tr("Victims whose radio tag is in reach, with distance in meters and direction in degrees."), true};
    for (const protocol::TaggedVictim& one : reading.victims)
        list.rows.push_back(
            {.name = nameText(one.victim_name.empty() ? one.id : one.victim_name),
             .value = (one.victim_in_reader_m ? placeText(*one.victim_in_reader_m) : QObject::tr("in reach")) +
                      (one.status.empty() ? QString() : QStringLiteral(" · ") + nameText(one.status)),
             .mark = RowMark::On});
    if (list.rows.empty())
        list.rows.push_back(flagRow(QObject::tr("in reach"), false, {}, QObject::tr("nobody")));
    return list;
}

ReadingList tagsOf(const protocol::RfidReading& reading) {
    ReadingList list{
        "RFID", QObject::tr("radio tags"),
        QObject::tr("Radio tags in reach, with distance in meters, direction in degrees, and what is stored in "
                    "them. Sent only when this changes."),
        true};
    for (const protocol::SeenTag& tag : reading.tags)
        list.rows.push_back(
            {.name = QObject::tr("tag %1").arg(tag.id),
             .value = (tag.tag_in_reader_m ? placeText(*tag.tag_in_reader_m) : QObject::tr("in reach")) +
                      (tag.memory ? QStringLiteral(" · ") + nameText(*tag.memory) : QString()),
             .mark = RowMark::On});
    if (list.rows.empty())
        list.rows.push_back(flagRow(QObject::tr("in reach"), false, {}, QObject::tr("none")));
    return list;
}

ReadingList gasOf(const protocol::GasReading& reading) {
    return {
        "CO2Sensor",
        QObject::tr("gas"),
        QObject::tr("Density of each gas as the server sends it; no source tells its unit."),
        false,
        {{.name = nameText(reading.gas.empty() ? reading.name : reading.gas), .value = figure(reading.density, 2)}}};
}

ReadingList motionOf(const protocol::HumanMotionReading& reading) {
    return {"HumanMotion",
            QObject::tr("people moving"),
            QObject::tr("Probability that a person moves within the sensor's view, in percent, 0 to 100."),
            false,
            {rangedRow(nameText(reading.name), 100.0 * reading.probability, 0.0, 100.0, QStringLiteral("%"), 0)}};
}

ReadingList soundOf(const protocol::SoundReading& reading) {
    return {"Sound",
            QObject::tr("sound"),
            QObject::tr("How loud it is at the sensor, in decibels."),
            false,
            {{.name = nameText(reading.name), .value = figure(reading.loudness_db, 1), .unit = QStringLiteral("dB")}}};
}

ReadingList gpsOf(const protocol::GpsReading& reading) {
    ReadingList list{"GPS", QObject::tr("GPS"),
                     QObject::tr("Latitude (north is positive) and longitude (east is positive) in degrees; a "
                                 "fix takes four satellites."),
                     true};
    list.rows.push_back(flagRow(QObject::tr("fix"), reading.fix, QObject::tr("yes"), QObject::tr("no")));
    if (reading.satellites)
        list.rows.push_back({.name = QObject::tr("satellites"), .value = QString::number(*reading.satellites)});
    const auto angle = [&](const QString& name, const std::optional<double>& angle_rad) {
        if (angle_rad)
            list.rows.push_back({.name = name, .value = figure(degrees(*angle_rad), 6), .unit = degree_unit});
    };
    angle(QObject::tr("latitude"), reading.latitude_rad);
    angle(QObject::tr("longitude"), reading.longitude_rad);
    return list;
}

ReadingList compassOf(const protocol::CompassReading& reading) {
    return {"MagneticCompass",
            QObject::tr("magnetic compass"),
            QObject::tr(
                "The number as the server sends it: it is cut to a whole number and converted twice, so it has no unit "
                "and is no heading."),
            false,
            {{.name = nameText(reading.name), .value = figure(reading.raw_angle, 0)}}};
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
    return std::visit(
        Overloaded{[](const protocol::RobotState& state) { return withRows(jointsOf(state)); },
                   [&](const protocol::PackageState& state) { return withRows(linksOf(state, fitting)); },
                   [&](const protocol::EncoderReadings& reading) { return withRows(encodersOf(reading, fitting)); },
                   [](const protocol::TachometerReading& reading) { return withRows(wheelsOf(reading)); },
                   [](const protocol::TouchReadings& reading) { return withRows(touchesOf(reading)); },
                   [&](const protocol::RangeReadings& reading) { return withRows(rangesOf(reading, fitting)); },
                   [](const protocol::BallReading& reading) { return Answer(ballOf(reading)); },
                   [](const protocol::VictimReading& reading) { return Answer(victimsOf(reading)); },
                   [](const protocol::VictimTagReading& reading) { return Answer(taggedVictimsOf(reading)); },
                   [](const protocol::RfidReading& reading) { return Answer(tagsOf(reading)); },
                   [](const protocol::GasReading& reading) { return Answer(gasOf(reading)); },
                   [](const protocol::HumanMotionReading& reading) { return Answer(motionOf(reading)); },
                   [](const protocol::SoundReading& reading) { return Answer(soundOf(reading)); },
                   [](const protocol::GpsReading& reading) { return Answer(gpsOf(reading)); },
                   [](const protocol::CompassReading& reading) { return Answer(compassOf(reading)); },
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
