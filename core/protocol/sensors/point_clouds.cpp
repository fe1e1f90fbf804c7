#include "core/protocol/sensors/point_clouds.h"

#include <array>

#include "core/base/text.h"
#include "core/protocol/field_list.h"
#include "core/protocol/line_writer.h"
#include "core/protocol/readers/line_reading.h"
#include "core/protocol/wire_frame.h"

namespace usar::protocol {

namespace {

constexpr double unreal_units_per_m = 250.0;

/// Converts between Unreal's own frame (x forward, y right, z up) and ours; its own inverse.
Vec3 acrossUnreal(const Vec3& point) {
    return {point.x(), -point.y(), point.z()};
}

/// Reads points of three numbers each, which have `separators` between and around them. False, with an error, if one is
/// damaged.
bool readPoints(LineReading& line, std::string_view text, std::string_view separators, std::vector<Vec3>& points) {
    points.clear();
    const std::string_view all = text;
    while (true) {
        const std::size_t start = std::min(text.find_first_not_of(separators), text.size());
        text.remove_prefix(start);
        text = trimmed(text);
        if (text.empty())
            return true;
        std::string_view point = text.substr(0, text.find_first_of(separators));
        text.remove_prefix(point.size());
        std::array<double, 3> numbers;
        if (!takeNumbers(point, numbers) || !trimmed(point).empty()) {
            line.error(all, "point " + std::to_string(points.size() + 1) + " is not three numbers");
            return false;
        }
        points.emplace_back(numbers[0], numbers[1], numbers[2]);
    }
}

/// Lists the number and the extent of the points, as many thousand points are too many to list.
void listPoints(FieldList& fields, const std::vector<Vec3>& points_m) {
    fields.number("count", static_cast<double>(points_m.size()));
    if (points_m.empty())
        return;
    Vec3 smallest = points_m.front();
    Vec3 largest = smallest;
    for (const Vec3& point_m : points_m) {
        smallest = smallest.cwiseMin(point_m);
        largest = largest.cwiseMax(point_m);
    }
    fields.vector("smallest", smallest, "m");
    fields.vector("largest", largest, "m");
}

} // namespace

bool read(LineReading& line, PointCloud& out) {
    const Segment* points = nullptr;
    for (const Segment& segment : line.segments().all())
        if (segment.text.find(',') != std::string_view::npos && !sameWord(segment.key, "Name"))
            points = &segment;
    if (!points || !readPoints(line, points->text, ";", out.points_in_sensor_m))
        return false;
    for (Vec3& point : out.points_in_sensor_m)
        point = acrossUnreal(point) / unreal_units_per_m;
    out.time = line.time();
    out.name = line.segments().value("Name");
    return true;
}

void write(LineWriter& line, const PointCloud& cloud) {
    line.sensor(cloud.time, PointCloud::wire_types);
    line.segment("Name", cloud.name);
    line.text(" {");
    for (std::size_t i = 0; i < cloud.points_in_sensor_m.size(); ++i) {
        line.text(i == 0 ? "" : ";");
        line.numbers(acrossUnreal(cloud.points_in_sensor_m[i]) * unreal_units_per_m, Decimals::TwoRounded);
    }
    line.close();
}

void list(FieldList& fields, const PointCloud& cloud) {
    listPoints(fields, cloud.points_in_sensor_m);
}

bool read(LineReading& line, LineLaserReading& out) {
    const Segments& segments = line.segments();
    const Segment* const points = segments.find("Points");
    if (!points && !segments.find("Location"))
        return false;
    const std::optional<Pose> pose = line.pose(segments.value("Location"), segments.value("Orientation"));
    out.points_in_sensor_m.clear();
    if (!pose || (points && !readPoints(line, points->value, "[]", out.points_in_sensor_m)))
        return false;
    for (Vec3& point : out.points_in_sensor_m)
        point = acrossWire(point);
    out.sensor_in_map = *pose;
    out.time = line.time();
    out.name = segments.value("Name");
    return true;
}

void write(LineWriter& line, const LineLaserReading& reading) {
    const Pose on_wire = acrossWire(reading.sensor_in_map);
    line.sensor(reading.time, LineLaserReading::wire_types);
    line.segment("Name", reading.name);
    line.segment("Location", on_wire.position_m, Decimals::FourCut);
    line.segment("Orientation", {on_wire.roll_rad, on_wire.pitch_rad, on_wire.yaw_rad}, Decimals::FourCut);
    line.open("Points");
    for (const Vec3& point_m : reading.points_in_sensor_m) {
        line.text("[");
        line.numbers(acrossWire(point_m), Decimals::FourCut);
        line.text("]");
    }
    line.close();
}

void list(FieldList& fields, const LineLaserReading& reading) {
    fields.pose(reading.sensor_in_map);
    listPoints(fields, reading.points_in_sensor_m);
}

} // namespace usar::protocol
