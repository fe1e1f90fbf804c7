// The SEN message of RangeScanner and similar sensors: ranges in one plane.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/base/clock.h"

namespace usar::protocol {

class FieldList;
class LineReading;
class LineWriter;

/// One scan. Beams run from right to left: index 0 looks at -fov/2 (right; counterclockwise is positive), the last one
/// at +fov/2. The number of beams is the number of values, not the quotient of field of view and resolution. A beam
/// that hits nothing gives the maximum range; NaN means that the server sent no number.
/// On the wire: `SEN {Time 395.38} {Type RangeScanner} {Name S1} {Resolution 0.0174} {FOV 3.1415} {Range 1.5,2,…}`.
struct RangeScan {
    std::optional<Seconds> time{};
    std::string name{};
    double resolution_rad = 0.0;
    double fov_rad = 0.0;
    std::vector<double> ranges_m{};
    std::string type = "RangeScanner"; ///< value of Type on the wire: IRScanner, Laser …

    static constexpr std::string_view wire_types = "RangeScanner|IRScanner";

    /// Angle between neighboring beams. UT2004 truncates 0.01745 to 0.0174 on the wire, which adds up to half a degree
    /// over 181 beams. Field of view and count give the true step if they agree with the resolution to within 2 %;
    /// otherwise this is the resolution.
    double step_rad() const {
        const double even_rad = ranges_m.size() > 1 ? fov_rad / static_cast<double>(ranges_m.size() - 1) : 0.0;
        const double difference_rad = even_rad > resolution_rad ? even_rad - resolution_rad : resolution_rad - even_rad;
        return difference_rad <= 0.02 * resolution_rad ? even_rad : resolution_rad;
    }
    /// Angle of a beam in the scanner's frame, counterclockwise positive. `index` < ranges_m.size().
    double beamAngle_rad(std::size_t index) const { return -fov_rad / 2.0 + static_cast<double>(index) * step_rad(); }
    bool operator==(const RangeScan&) const = default;
};

/// Fills all of `out`. False if the line has no FOV, Resolution and Range, with an error if it has only some of them.
bool read(LineReading& line, RangeScan& out);
/// Reads a SEN of any Type with a Range and a single number for FOV and for Resolution, because scanners have many type
/// names (RangeScanner, IRScanner, Laser …). False for any other line.
bool readByShape(LineReading& line, RangeScan& out);
/// Writes the line as UT2004 does, without CR LF.
void write(LineWriter& line, const RangeScan& scan);
/// Adds resolution and field of view, and a summary of the ranges; the caller has set source and item.
void list(FieldList& fields, const RangeScan& scan);

} // namespace usar::protocol
