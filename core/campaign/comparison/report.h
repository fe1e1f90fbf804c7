// All reports of a comparison are made from this, and share its words.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <QString>

#include "core/campaign/comparison/comparison.h"

namespace usar::campaign {

/// Names and values to be given as they are: versions, hashes, machine, processor time.
using ReportFacts = std::vector<std::pair<std::string, std::string>>;

/// The comparison and the runs it was made from belong to the caller.
struct Report {
    const Comparison& comparison;
    const std::vector<RunFigures>& runs;
    std::string title; ///< of the campaign
    ReportFacts facts;
};

/// Several candidates compared with one baseline. The comparisons, of which there is at least one, and the runs belong
/// to the caller.
struct CampaignReport {
    const std::vector<Comparison>& comparisons;
    const std::vector<RunFigures>& runs;
    std::string title;
    ReportFacts facts;
};

/// One sentence without a period: "posh is worse than cpp".
QString headline(const Comparison& comparison);

/// "about 120 more seeds would decide", rounded up to two digits; empty if everything is decided.
QString outlook(const std::optional<std::size_t>& more_seeds);

/// Sentences on runs that were not done, and on what was not compared, one each; empty if all runs were done and were.
std::vector<QString> omissions(const Comparison& comparison);

/// "Duration as a mean to the limit of 300.0 s: old 121.5 s, of which 2 runs were not done, new …", for each figure
/// that counts the limit where a run was not done.
std::vector<QString> restrictedMeans(const Comparison& comparison);
/// "to 300.0 s"; "to their limits" where missions have several.
QString restrictionOf(const MetricComparison& result);

/// Sentences that name the seeds on which only one of the variants had success: "Only old has success on 2 seeds:
/// 8, 16."
std::vector<QString> differingSeeds(const Comparison& comparison);

/// The seed of a run; with its mission if the comparison has several.
QString seedOf(const RunFigures& run, const Comparison& comparison);

/// "12.5 s", with the metric's decimals; a dash if it is not a number. A difference always has its sign, and one of
/// percentages is in points.
QString amount(double value, const Metric& metric, bool is_difference = false);
/// "-3.1 to -1.2 s"
QString amount(const Interval& interval, const Metric& metric);

/// "45 of 50, 90.0 %"
QString amount(const Count& count);
/// A share in percent with one decimal, without the sign of percent: "90.0".
QString percent(double share, bool with_sign = false);

/// "0.012", or "< 0.001".
QString pValue(double p);

/// Returns the value with two decimals; a dash if it is not a number.
QString plain(double value);

/// Removes the characters that XML does not allow, which a robot's or a program's words may hold.
QString printable(const std::string& text);

/// The name of a mission or variant; a word in place of an empty one.
QString nameOf(const std::string& name);

} // namespace usar::campaign
