// How often each value of a figure came out, for each variant of a campaign.
#pragma once

#include <vector>

#include <QString>

#include "widgets/models/campaign/campaign_run.h"

namespace usar::widgets {

/// The runs of one variant, counted.
struct VariantCounts {
    QString variant;
    std::vector<int> counts;   ///< There is one for each bin, of the runs that were done.
    std::vector<int> not_done; ///< The same of those that were not.
    int unknown = 0;           ///< These runs have no such figure.
    bool operator==(const VariantCounts&) const = default;
};

/// The bins are shared by all variants, so that their bars can stand beside each other.
struct RunHistogram {
    double from = 0.0;  ///< The first bin begins here, in the metric's unit.
    double width = 1.0; ///< Every bin is that wide, in the same unit; a value on an edge belongs to the upper bin.
    int bins = 0;       ///< It is 0 if no run has the figure.
    std::vector<VariantCounts> variants;

    /// The middle of a bin, in the metric's unit.
    double middle(int bin) const { return from + (bin + 0.5) * width; }
    /// The most runs of one variant in one bin, done or not.
    int highest() const;
    bool anyNotDone() const;
    bool operator==(const RunHistogram&) const = default;
};

/// Counts one metric. Bins begin at a multiple of their width, which is 1, 2 or 5 times a power of ten, and there are
/// at most `most_bins` of them. Variants are in the order in which they first appear.
RunHistogram histogramOf(const std::vector<CampaignRun>& runs, std::size_t metric, int most_bins = 20);

} // namespace usar::widgets
