// One run of a campaign, and what is measured of each run, as the views of a campaign show them.
#pragma once

#include <optional>
#include <vector>

#include <QString>

namespace usar::widgets {

/// A figure that every run may have.
struct CampaignMetric {
    QString title; ///< It is the head of a column: "Coverage".
    QString unit;  ///< It is empty for counts.
    int decimals = 0;
    bool operator==(const CampaignMetric&) const = default;
};

/// A run that has ended.
struct CampaignRun {
    int number = 0;
    int pair = 0; ///< Runs of one pair differ in the variant alone.
    QString mission{};
    QString variant{};
    quint64 seed = 0;
    QString outcome{}; ///< It is the word of the result line, such as "done" or "failed".
    bool done = false;
    QString reason{};
    std::vector<std::optional<double>> figures{}; ///< They are in the order of the metrics.
    bool differs = false;                         ///< It was flown twice and came out differently.
    bool operator==(const CampaignRun&) const = default;
};

/// "98.25 %", or a dash for a figure that is not known.
QString figureText(const CampaignRun& run, std::size_t metric, const std::vector<CampaignMetric>& metrics);

} // namespace usar::widgets
