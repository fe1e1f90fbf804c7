// Plans for tests: our own in tests/data/posh, and larger collections where they are found.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace corpus {

/// Where and what the first error of a plan is; a column counts code points.
struct ExpectedError {
    unsigned line = 0;
    unsigned column = 0;
    std::string code;
};

struct PlanFile {
    std::string name; ///< "valid/tour.lap", for naming rows
    std::string text;
    std::optional<ExpectedError> error; ///< nothing: the plan is sound
    std::map<std::string, int> counts;  ///< "levels", "drives", "C" …, where the collection tells them
};

/// Every .lap below tests/data/posh, below shared/corpus/posh beside the checkout, and below each folder that the
/// environment variable USAR_POSH_PLANS names (with colons between). EXPECTED.tsv in a folder, or above it, lists those
/// of its plans that have an error: file, line, column, code; SOURCES.txt beside or above it may tell the counts of
/// others.
std::vector<PlanFile> planFiles();
std::vector<PlanFile> soundPlans();

} // namespace corpus
