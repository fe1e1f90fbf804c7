// Reads from the folders of campaigns what a comparison needs.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <QStringList>

#include "core/base/result.h"
#include "core/campaign/comparison/run_figures.h"

namespace usar::campaign {

/// All runs of one campaign, or of two whose variants are compared.
struct CampaignFigures {
    std::string title;
    std::vector<RunFigures> runs;
    std::vector<std::string> variants; ///< in the order of the campaigns
    std::size_t of_first = 0;          ///< so many of them are the first campaign's
    std::size_t planned = 0;           ///< so many runs the campaigns have, flown or not
    /// Names and values for reports: versions, hashes, processor time.
    std::vector<std::pair<std::string, std::string>> facts;
};

/// A variant that is to be compared with a baseline.
struct Candidate {
    std::string variant;
    std::optional<Error> trouble; ///< why it cannot be compared: it has no runs yet
};

/// All variants but the baseline, in their order; of two campaigns those of the one that the baseline is not of.
std::vector<Candidate> candidatesFor(const std::string& baseline, const CampaignFigures& figures);

/// "39 of 80 runs have no result yet."; empty if all have.
QString missingRuns(const CampaignFigures& figures);

/// The figures of a result that are compared.
RunFigures figuresOf(const RunResult& result);

/// Reads the manifest and the results of one or two campaigns. With two, each variant has the name of its folder added,
/// or as much of its path as tells the two apart, and pairs of equal numbers must have the same mission and seed. Fails
/// if a folder is given twice, holds no campaign or no results, and on results of another version than its manifest's.
Result<CampaignFigures> readCampaigns(const QStringList& folders);

} // namespace usar::campaign
