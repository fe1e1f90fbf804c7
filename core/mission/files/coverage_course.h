// How the coverage of a mission area grew.
#pragma once

#include <cstddef>
#include <vector>

#include "core/base/clock.h"

namespace usar::mission {

/// Share of the area whose height was known at a time of the run.
struct CoveragePoint {
    Seconds elapsed{0.0}; ///< since the behavior started, protocol clock
    double coverage_pct = 0.0;
    bool operator==(const CoveragePoint&) const = default;
};

/// Keeps a point every few seconds of the protocol's clock, the fewer the longer the run lasts: the number of points
/// has a limit, and equal runs have equal points.
class CoverageCourse {
public:
    static constexpr std::size_t most = 64;

    /// True if a point is due at this time; `add` it then. Finding out the coverage takes time, so it is only done for
    /// the points.
    bool due(Seconds elapsed) const { return elapsed >= next_; }
    void add(const CoveragePoint& point);
    const std::vector<CoveragePoint>& points() const { return points_; }
    bool operator==(const CoverageCourse&) const = default;

private:
    Seconds pause_{5.0};
    Seconds next_{0.0};
    std::vector<CoveragePoint> points_;
};

} // namespace usar::mission
