// SEN messages of sensors that deliver points: UDK's PCL and LineLaser.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/clock.h"
#include "core/base/geometry.h"

namespace usar::protocol {

class FieldList;
class LineReading;
class LineWriter;

/// Points in the sensor's frame. On the wire they are in raw Unreal units, 250 per meter, with y right and z up.
/// On the wire: `SEN {Time 34.7} {Type PCL} {Name p} {250.00,-500.00,125.00;500.00,-250.00,250.00}`.
struct PointCloud {
    std::optional<Seconds> time{};
    std::string name{};
    std::vector<Vec3> points_in_sensor_m{};

    static constexpr std::string_view wire_types = "PCL";
    bool operator==(const PointCloud&) const = default;
};

/// Fills all of `out`. False if the line has no points, or, with an error, if one of them is damaged.
bool read(LineReading& line, PointCloud& out);
/// Writes the line without CR LF.
void write(LineWriter& line, const PointCloud& cloud);
/// Adds the number of points and their extent; the caller has set source and item.
void list(FieldList& fields, const PointCloud& cloud);

/// The points that a line of laser light hits, possibly none, and the sensor's pose.
/// On the wire: `SEN {Type LineLaser} {Name l} {Location 1,2,3} {Orientation 0,0,1.5} {Points [1,0,0][1,1,0]}`.
struct LineLaserReading {
    std::optional<Seconds> time{};
    std::string name{};
    Pose sensor_in_map{};
    std::vector<Vec3> points_in_sensor_m{};

    static constexpr std::string_view wire_types = "LineLaser";
    bool operator==(const LineLaserReading&) const = default;
};

/// Fills all of `out`. False if the line has neither pose nor points, or, with an error, if one of them is damaged.
bool read(LineReading& line, LineLaserReading& out);
void write(LineWriter& line, const LineLaserReading& reading);
/// Adds the sensor's pose, and the points as above.
void list(FieldList& fields, const LineLaserReading& reading);

} // namespace usar::protocol
