// Counts of the traffic on one connection, as shown in link panels.
#pragma once

#include <cstdint>

namespace usar::protocol {

/// Totals since the connection was established; a new connection starts at zero. Bytes include line ends and dropped
/// lines.
struct TrafficCounts {
    std::uint64_t lines_in = 0;
    std::uint64_t lines_out = 0;
    std::uint64_t bytes_in = 0;
    std::uint64_t bytes_out = 0;
    std::uint64_t unknown = 0;         ///< lines of unknown type; kept whole
    std::uint64_t malformed = 0;       ///< lines with errors; what could be read was kept
    std::uint64_t dropped = 0;         ///< lines discarded because they exceeded the cap
    std::uint64_t drives_replaced = 0; ///< DRIVE commands replaced by newer ones before they were sent
    bool operator==(const TrafficCounts&) const = default;
};

/// Rates per second of wall time, averaged over about half a second.
struct TrafficRates {
    double lines_in_per_s = 0.0;
    double lines_out_per_s = 0.0;
    double bytes_in_per_s = 0.0;
    double bytes_out_per_s = 0.0;
};

} // namespace usar::protocol
