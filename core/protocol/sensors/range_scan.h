// SEN RangeScanner and its kin: one plane of ranges.
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

/// Beams run from right to left: index 0 looks at -fov/2 (right; counter-clockwise positive), the last one at +fov/2.
/// The count of values rules, not the quotient of field of view and resolution. A miss reads the maximum range; NaN
/// where the server sent no number.
struct RangeScan {
    std::optional<Seconds> time{};
    std::string name{};
    double resolution_rad = 0.0;
    double fov_rad = 0.0;
    std::vector<double> ranges_m{};
    std::string type = "RangeScanner"; ///< on the wire; scanners go by many: IRScanner, Laser …

    static constexpr std::string_view wire_types = "RangeScanner|IRScanner";

    /// Angle between neighbouring beams. UT2004 cuts 0.01745 to 0.0174 on the wire, which adds up to half a degree over
    /// 181 beams; field of view and count give the true step wherever they agree with the resolution to 2 %.
    double step_rad() const {
        const double even_rad = ranges_m.size() > 1 ? fov_rad / static_cast<double>(ranges_m.size() - 1) : 0.0;
        const double difference_rad = even_rad > resolution_rad ? even_rad - resolution_rad : resolution_rad - even_rad;
        return difference_rad <= 0.02 * resolution_rad ? even_rad : resolution_rad;
    }
    /// Angle of a beam in the scanner's frame, counter-clockwise positive. `index` < ranges_m.size().
    double beamAngle_rad(std::size_t index) const { return -fov_rad / 2.0 + static_cast<double>(index) * step_rad(); }
    bool operator==(const RangeScan&) const = default;
};

bool read(LineReading& line, RangeScan& out);
/// Scanners go by many names (RangeScanner, IRScanner, Laser …): any SEN with one FOV, one Resolution and a Range.
bool readByShape(LineReading& line, RangeScan& out);
void write(LineWriter& line, const RangeScan& scan);
void list(FieldList& fields, const RangeScan& scan);

} // namespace usar::protocol
