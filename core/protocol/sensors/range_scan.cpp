#include "core/protocol/sensors/range_scan.h"

#include "core/base/numbers.h"
#include "core/protocol/field_list.h"
#include "core/protocol/readers/line_reading.h"
#include "core/protocol/writer_parts.h"

namespace usar::protocol {

bool read(LineReading& line, RangeScan& out) {
    const Segments& segments = line.segments();
    const Segment* const range = segments.find("Range");
    if (!range && !segments.find("FOV") && !segments.find("Resolution"))
        return false;
    const std::optional<double> fov_rad = line.number("FOV");
    const std::optional<double> resolution_rad = line.number("Resolution");
    if (!range || !fov_rad || !resolution_rad) {
        line.error(segments.line(), "a scan needs FOV, Resolution and Range");
        return false;
    }
    out.time = line.time();
    out.name = segments.value("Name");
    out.type = segments.value("Type");
    if (sameWord(out.type, firstType(RangeScan::wire_types)))
        out.type = firstType(RangeScan::wire_types);
    out.resolution_rad = *resolution_rad;
    out.fov_rad = *fov_rad;
    const std::size_t doubtful = readNumberList(range->value, out.ranges_m);
    if (doubtful > 0)
        line.warn(range->text, std::to_string(doubtful) + " of " + std::to_string(out.ranges_m.size()) +
                                   " ranges are not plain numbers");
    return true;
}

bool readByShape(LineReading& line, RangeScan& out) {
    const Segments& segments = line.segments();
    return segments.find("Range") && readNumber(segments.value("FOV")) && readNumber(segments.value("Resolution")) &&
           read(line, out); // 3D scanners and imagers send two numbers as FOV and Resolution
}

void write(LineWriter& line, const RangeScan& scan) {
    line.text("SEN");
    line.time(scan.time, Decimals::TwoRounded);
    line.segmentIfAny("Type", scan.type);
    writeScan(line, scan, Decimals::FourCut);
}

void list(FieldList& fields, const RangeScan& scan) {
    fields.number("resolution", scan.resolution_rad, "rad");
    fields.number("fov", scan.fov_rad, "rad");
    fields.summary("", scan.ranges_m, "m");
}

} // namespace usar::protocol
