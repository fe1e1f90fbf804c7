#include "core/mapping/scan_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

namespace usar::mapping {

namespace {

constexpr std::size_t piece_bytes = std::size_t(1) << 20;

/// Sends the records of all points in pieces; `add` appends the record of one.
template <class Add>
bool sendPoints(std::span<const KeptScan> scans, const ByteSink& sink, Add add) {
    ByteBuffer piece;
    piece.reserve(piece_bytes + 64);
    const bool sent = eachPoint(scans, [&](const ScanPoint& point) {
        add(piece, point);
        return piece.size() < piece_bytes || piece.sendTo(sink);
    });
    return sent && piece.sendTo(sink);
}

// Sizes of LAS 1.2, and of the description of extra bytes in LAS 1.4.
constexpr std::uint16_t header_bytes = 227;
constexpr std::uint16_t record_header_bytes = 54;
constexpr std::uint16_t extra_bytes_description = 192;
constexpr std::uint16_t point_bytes = 28 + 4; ///< format 1, and the range
constexpr std::uint8_t type_float = 9;        ///< code of a float in that description
constexpr std::uint8_t only_return = 1 | 1 << 3;

/// One axis of a LAS file: coordinates are whole numbers times `scale_m` plus `offset_m`.
struct Axis {
    double scale_m = 0.001;
    double offset_m = 0.0;
    std::int32_t least = 0;
    std::int32_t most = 0;

    std::int32_t number(double value_m) const {
        return static_cast<std::int32_t>(std::llround((value_m - offset_m) / scale_m));
    }
    double value_m(std::int32_t number) const { return number * scale_m + offset_m; }
};

struct LasFrame {
    std::array<Axis, 3> axes;
    std::uint32_t count = 0;
};

LasFrame frameOf(std::span<const KeptScan> scans) {
    LasFrame frame;
    Vec3 least_m = Vec3::Constant(std::numeric_limits<double>::max()), most_m = -least_m;
    eachPoint(scans, [&](const ScanPoint& point) {
        least_m = least_m.cwiseMin(point.at_m);
        most_m = most_m.cwiseMax(point.at_m);
        return ++frame.count > 0;
    });
    for (int i = 0; frame.count > 0 && i < 3; ++i) {
        Axis& axis = frame.axes[std::size_t(i)];
        axis.offset_m = std::floor(least_m[i]);
        while ((most_m[i] - axis.offset_m) / axis.scale_m > double(std::numeric_limits<std::int32_t>::max()))
            axis.scale_m *= 10.0;
        axis.least = axis.number(least_m[i]);
        axis.most = axis.number(most_m[i]);
    }
    return frame;
}

ByteBuffer lasHeader(const LasFrame& frame, CreationDay day) {
    ByteBuffer header;
    header.add(std::string_view("LASF"));
    header.addZeros(2 + 2 + 16); // file source, global encoding, and no project
    header.add(std::uint8_t(1));
    header.add(std::uint8_t(2));
    header.addField("USARSim range scanner", 32);
    header.addField("USAR Mission Control", 32);
    header.add(day.day_of_year);
    header.add(day.year);
    header.add(header_bytes);
    header.add(std::uint32_t(header_bytes + record_header_bytes + extra_bytes_description));
    header.add(std::uint32_t(1)); // variable length records
    header.add(std::uint8_t(1));  // format of the points
    header.add(point_bytes);
    header.add(frame.count);
    header.add(frame.count); // All are first returns.
    header.addZeros(4 * 4);
    for (const Axis& axis : frame.axes)
        header.add(axis.scale_m);
    for (const Axis& axis : frame.axes)
        header.add(axis.offset_m);
    for (const Axis& axis : frame.axes) {
        header.add(axis.value_m(axis.most));
        header.add(axis.value_m(axis.least));
    }
    return header;
}

/// The variable length record that says what the bytes behind each point are.
void describeRange(ByteBuffer& header) {
    header.addZeros(2);
    header.addField("LASF_Spec", 16);
    header.add(std::uint16_t(4)); // Extra Bytes
    header.add(extra_bytes_description);
    header.addField("range of each point", 32);
    header.addZeros(2);
    header.add(type_float);
    header.addZeros(1); // It has no special values, limits or scale.
    header.addField("range", 32);
    header.addZeros(4 + 8 + 16 + 4 * (8 + 16));
    header.addField("from the scanner, in meters", 32);
}

void addLasPoint(ByteBuffer& piece, const ScanPoint& point, const LasFrame& frame) {
    for (int i = 0; i < 3; ++i)
        piece.add(frame.axes[std::size_t(i)].number(point.at_m[i]));
    piece.addZeros(2); // no intensity
    piece.add(only_return);
    piece.addZeros(1); // never classified
    piece.add(static_cast<std::int8_t>(std::lround(std::clamp(degrees(point.angle_rad), -90.0, 90.0))));
    piece.addZeros(1);
    piece.add(static_cast<std::uint16_t>(point.scanner + 1));
    piece.add(point.time.count());
    piece.add(static_cast<float>(point.range_m));
}

} // namespace

bool writePly(std::span<const KeptScan> scans, const ByteSink& sink) {
    std::uint64_t count = 0;
    eachPoint(scans, [&](const ScanPoint&) { return ++count > 0; });
    const std::string header = "ply\nformat binary_little_endian 1.0\n"
                               "comment map frame in meters, z up; time in seconds; range from the scanner in meters\n"
                               "element vertex " +
                               std::to_string(count) +
                               "\nproperty float x\nproperty float y\nproperty float z\n"
                               "property double time\nproperty float range\nend_header\n";
    return sink(header.data(), header.size()) && sendPoints(scans, sink, [](ByteBuffer& piece, const ScanPoint& point) {
               for (const double value_m : point.at_m)
                   piece.add(static_cast<float>(value_m));
               piece.add(point.time.count());
               piece.add(static_cast<float>(point.range_m));
           });
}

bool writeLas(std::span<const KeptScan> scans, CreationDay day, const ByteSink& sink) {
    const LasFrame frame = frameOf(scans);
    ByteBuffer header = lasHeader(frame, day);
    describeRange(header);
    return header.sendTo(sink) && sendPoints(scans, sink, [&frame](ByteBuffer& piece, const ScanPoint& point) {
               addLasPoint(piece, point, frame);
           });
}

} // namespace usar::mapping
