#include "plan_corpus.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace corpus {

namespace {

namespace fs = std::filesystem;

std::string contentOf(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> parts;
    std::istringstream in(text);
    for (std::string part; std::getline(in, part, separator);)
        parts.push_back(part);
    return parts;
}

std::vector<fs::path> folders() {
    std::vector<fs::path> result{fs::path(USAR_SOURCE_DIR) / "tests/data/posh",
                                 fs::path(USAR_SOURCE_DIR) / "../shared/corpus/posh"};
    if (const char* const named = std::getenv("USAR_POSH_PLANS"))
        for (const std::string& folder : split(named, ':'))
            result.emplace_back(folder);
    return result;
}

/// File name to what is wrong with it.
std::map<std::string, ExpectedError> expectedErrors(const fs::path& folder) {
    std::map<std::string, ExpectedError> errors;
    for (const std::string& line : split(contentOf(folder / "EXPECTED.tsv"), '\n')) {
        const auto columns = split(line, '\t');
        if (columns.size() >= 4 && !line.starts_with('#') && columns[3].starts_with('E'))
            errors[columns[0]] = {static_cast<unsigned>(std::stoul(columns[1])),
                                  static_cast<unsigned>(std::stoul(columns[2])), columns[3]};
    }
    return errors;
}

/// "RDC levels=2 drives=2 C=0": words without = are passed over.
std::map<std::string, int> countsIn(const std::string& text) {
    std::map<std::string, int> counts;
    for (const std::string& word : split(text, ' '))
        if (const std::size_t sign = word.find('='); sign != std::string::npos && sign + 1 < word.size())
            counts[word.substr(0, sign)] = std::atoi(word.c_str() + sign + 1);
    return counts;
}

std::map<std::string, std::map<std::string, int>> knownCounts(const fs::path& folder) {
    std::map<std::string, std::map<std::string, int>> known;
    for (const std::string& line : split(contentOf(folder / "SOURCES.txt"), '\n'))
        if (const std::size_t bar = line.find(" | "); bar != std::string::npos)
            known[line.substr(0, bar)] = countsIn(line);
    return known;
}

void appendFolder(const fs::path& root, std::vector<PlanFile>& plans) {
    std::error_code problem;
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(root, problem))
        if (entry.path().extension() == ".lap")
            files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    const auto counts = knownCounts(root);
    const auto errors_of_all = expectedErrors(root);
    for (const fs::path& file : files) {
        PlanFile plan{fs::relative(file, root).generic_string(), contentOf(file), std::nullopt, {}};
        const auto errors = expectedErrors(file.parent_path());
        const auto error = errors.find(file.filename().string());
        if (error != errors.end())
            plan.error = error->second;
        else if (const auto listed = errors_of_all.find(plan.name); listed != errors_of_all.end())
            plan.error = listed->second;
        if (const auto known = counts.find(plan.name); known != counts.end())
            plan.counts = known->second;
        plans.push_back(std::move(plan));
    }
}

} // namespace

std::vector<PlanFile> planFiles() {
    std::vector<PlanFile> plans;
    for (const fs::path& folder : folders())
        appendFolder(folder, plans);
    return plans;
}

std::vector<PlanFile> soundPlans() {
    std::vector<PlanFile> plans = planFiles();
    std::erase_if(plans, [](const PlanFile& plan) { return plan.error.has_value(); });
    return plans;
}

} // namespace corpus
