// What went over one connection, counted: the figures of link panels.
#pragma once

#include <cstdint>

namespace usar::protocol {

/// Since the connection was made; a new connection starts at zero. Bytes include line ends, and those of lines that
/// were dropped.
struct TrafficCounts {
    std::uint64_t lines_in = 0;
    std::uint64_t lines_out = 0;
    std::uint64_t bytes_in = 0;
    std::uint64_t bytes_out = 0;
    std::uint64_t unknown = 0;         ///< lines of a type that no table knows; kept whole
    std::uint64_t malformed = 0;       ///< lines with something wrong in them; what could be read was kept
    std::uint64_t dropped = 0;         ///< lines longer than the reader's cap, left out
    std::uint64_t drives_replaced = 0; ///< DRIVE commands that a newer one replaced before their turn
    bool operator==(const TrafficCounts&) const = default;
};

/// Of wall time, measured over about half a second.
struct TrafficRates {
    double lines_in_per_s = 0.0;
    double lines_out_per_s = 0.0;
    double bytes_in_per_s = 0.0;
    double bytes_out_per_s = 0.0;
};

} // namespace usar::protocol
