// What a strip adjustment has found out.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "core/mapping/path_correction.h"

namespace usar::mapping {

/// Adjusted: by the overlaps. Bridged: only by what the settings of the INS have shown. Declined: not at all.
enum class AdjustmentVerdict { Declined, Bridged, Adjusted };

/// The result of a strip adjustment. Without a correction the path stays as it is.
struct StripResult {
    AdjustmentVerdict verdict = AdjustmentVerdict::Declined;
    std::string reason; ///< a sentence
    /// Root mean square of the differences in height between looks at one cell, at least 25 s apart, with the path as
    /// it was estimated and with the corrected one; both over the same pairs of intervals of the path, if there are
    /// any that overlap with both (StripResidual). Differences count at most 1 m, so that leaves in the wind and cells
    /// with two floors do not hide the rest. Absent without overlaps.
    std::optional<double> residual_before_m{};
    std::optional<double> residual_after_m{}; ///< of the correction; equal to `residual_before_m` if it was declined
    std::size_t overlaps = 0;                 ///< pairs of looks on the finest grid
    PathCorrection correction{};              ///< empty if it was declined
};

} // namespace usar::mapping
