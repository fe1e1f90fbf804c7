// SEN of sensors that give points: UDK's PCL and LineLaser.
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

/// Points in the sensor's frame. The wire has raw Unreal units, 250 of them a metre, z up and y right.
struct PointCloud {
    std::optional<Seconds> time{};
    std::string name{};
    std::vector<Vec3> points_in_sensor_m{};

    static constexpr std::string_view wire_types = "PCL";
    bool operator==(const PointCloud&) const = default;
};

bool read(LineReading& line, PointCloud& out);
void write(LineWriter& line, const PointCloud& cloud);
void list(FieldList& fields, const PointCloud& cloud);

/// Points that a line of light hits, and where the sensor was.
struct LineLaserReading {
    std::optional<Seconds> time{};
    std::string name{};
    Pose sensor_in_map{};
    std::vector<Vec3> points_in_sensor_m{};

    static constexpr std::string_view wire_types = "LineLaser";
    bool operator==(const LineLaserReading&) const = default;
};

bool read(LineReading& line, LineLaserReading& out);
void write(LineWriter& line, const LineLaserReading& reading);
void list(FieldList& fields, const LineLaserReading& reading);

} // namespace usar::protocol
