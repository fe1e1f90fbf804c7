// The points that the beams of a scan have hit, as files for programs that show point clouds.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/mapping/byte_stream.h"
#include "core/mapping/scan_store.h"

namespace usar::mapping {

/// Where a beam ended.
struct ScanPoint {
    Vec3 at_m = Vec3::Zero(); ///< map frame
    Seconds time{0.0};        ///< KeptScan::time
    double range_m = 0.0;     ///< from the scanner
    double angle_rad = 0.0;   ///< direction of the beam in its scan, see Beams
    std::uint32_t scanner = 0;
};

/// Calls `take` with each point, in the order of scans and beams; false as soon as it is.
template <class Take>
bool eachPoint(std::span<const KeptScan> scans, Take take) {
    HitFinder finder;
    std::vector<double> ranges_m;
    std::vector<Vec3> hits_m;
    for (const KeptScan& scan : scans) {
        const Beams beams = scan.beams(ranges_m);
        finder.find(beams, scan.scanner_in_map, hits_m);
        for (std::size_t beam = 0; beam < hits_m.size(); ++beam)
            if (hits_m[beam].allFinite() &&
                !take(ScanPoint{hits_m[beam], scan.time, ranges_m[beam], beams.angle_rad(beam), scan.scanner}))
                return false;
    }
    return true;
}

/// Sends a binary little-endian PLY with the properties x, y, z (float, m), time (double, s) and range (float, m);
/// false as soon as `sink` is.
bool writePly(std::span<const KeptScan> scans, const ByteSink& sink);

/// The day of a file, as LAS states it.
struct CreationDay {
    std::uint16_t day_of_year = 0; ///< from 1
    std::uint16_t year = 0;
};

/// Sends a LAS 1.2 with points of format 1: coordinates as multiples of a millimeter, or of as many tens of it as are
/// needed to hold all; the time in the field of the GPS time; the angle of the beam as scan angle rank, in whole
/// degrees from -90 to 90; the number of the scanner, from 1, as point source. The range follows as a float, which a
/// record of extra bytes describes. False as soon as `sink` is.
bool writeLas(std::span<const KeptScan> scans, CreationDay day, const ByteSink& sink);

} // namespace usar::mapping
