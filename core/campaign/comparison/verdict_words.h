// A comparison in words, for a window: what is better, by how much, and what would decide the rest.
#pragma once

#include <vector>

#include <QString>

#include "core/campaign/comparison/comparison.h"

namespace usar::campaign {

/// The word on one figure.
struct VerdictLine {
    QString title; ///< "Duration"
    QString word;  ///< "better", of the candidate
    QString
        detail; ///< "C++ 112.6 s, POSH 100.1 s; in pairs -12.5 s (-14.0 to -11.0 s)", and how many more would decide
    bool operator==(const VerdictLine&) const = default;
};

/// Success first, then the metrics in the order of the comparison.
std::vector<VerdictLine> verdictLines(const Comparison& comparison);

} // namespace usar::campaign
