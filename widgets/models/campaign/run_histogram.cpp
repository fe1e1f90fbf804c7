#include "widgets/models/campaign/run_histogram.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace usar::widgets {

namespace {

std::optional<double> valueOf(const CampaignRun& run, std::size_t metric) {
    const auto value = metric < run.figures.size() ? run.figures[metric] : std::nullopt;
    return value && std::isfinite(*value) ? value : std::nullopt;
}

/// The least of 1, 2 and 5 times a power of ten that is not less than `least`.
double roundWidth(double least) {
    const double power = std::pow(10.0, std::floor(std::log10(least)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power >= least * (1.0 - 1e-9))
            return factor * power;
    return 10.0 * power;
}

VariantCounts& countsOf(RunHistogram& histogram, const QString& variant) {
    const auto found = std::ranges::find(histogram.variants, variant, &VariantCounts::variant);
    if (found != histogram.variants.end())
        return *found;
    return histogram.variants.emplace_back(
        VariantCounts{variant, std::vector<int>(static_cast<std::size_t>(histogram.bins), 0),
                      std::vector<int>(static_cast<std::size_t>(histogram.bins), 0), 0});
}

} // namespace

int RunHistogram::highest() const {
    int most = 0;
    for (const VariantCounts& one : variants)
        for (std::size_t bin = 0; bin < one.counts.size(); ++bin)
            most = std::max(most, one.counts[bin] + one.not_done[bin]);
    return most;
}

bool RunHistogram::anyNotDone() const {
    return std::ranges::any_of(variants, [](const VariantCounts& one) {
        return std::ranges::any_of(one.not_done, [](int count) { return count > 0; });
    });
}

RunHistogram histogramOf(const std::vector<CampaignRun>& runs, std::size_t metric, int most_bins) {
    std::optional<double> least, most;
    for (const CampaignRun& run : runs)
        if (const auto value = valueOf(run, metric)) {
            least = std::min(*value, least.value_or(*value));
            most = std::max(*value, most.value_or(*value));
        }
    RunHistogram histogram;
    if (least) {
        // One bin less than there may be, because the first one begins below the least value.
        const double span = *most - *least;
        histogram.width = span > 0.0 ? roundWidth(span / std::max(1, most_bins - 1)) : 1.0;
        histogram.from = std::floor(*least / histogram.width) * histogram.width;
        histogram.bins = 1 + static_cast<int>(std::floor((*most - histogram.from) / histogram.width));
    }
    for (const CampaignRun& run : runs) {
        VariantCounts& counts = countsOf(histogram, run.variant);
        if (const auto value = valueOf(run, metric)) {
            const int bin = static_cast<int>(std::floor((*value - histogram.from) / histogram.width));
            ++(run.done ? counts.counts
                        : counts.not_done)[static_cast<std::size_t>(std::clamp(bin, 0, histogram.bins - 1))];
        } else {
            ++counts.unknown;
        }
    }
    return histogram;
}

} // namespace usar::widgets
