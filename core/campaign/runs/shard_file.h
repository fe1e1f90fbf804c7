// Shard files: results of a campaign's runs, one line each, which are only ever appended.
#pragma once

#include <memory>
#include <vector>

#include <QFile>
#include <QString>

#include "core/base/result.h"
#include "core/campaign/runs/division.h"
#include "core/campaign/runs/run_result.h"

namespace usar::campaign {

/// One part of a campaign: every `of`-th pair, from number `index` on. Pairs are never divided, so that a machine that
/// is different changes both sides of a comparison.
struct Shard {
    int index = 0; ///< 0 .. of - 1
    int of = 1;
    bool has(const PlannedRun& run) const { return run.pair % of == index; }
    bool operator==(const Shard&) const = default;
};

/// A file that is being written. The kernel locks it against a second writer for as long as this process lives.
class ShardFile {
public:
    /// Opens DIR/shard-INDEX.jsonl for appending. A last line without its end, which a killed writer leaves, is
    /// removed. Fails if another process writes it or divides the campaign otherwise, or if it cannot be written.
    static Result<ShardFile> open(const QString& folder, const Shard& shard);

    /// Writes one line and hands it to the kernel, so that it survives the end of this process.
    Result<void> append(const RunResult& result);

private:
    ShardFile(std::unique_ptr<QFile> file, Division division)
        : file_(std::move(file))
        , division_(std::move(division)) {}
    std::unique_ptr<QFile> file_;
    Division division_; ///< taken for as long as the file is written
};

/// Where the run with this number keeps its files: FOLDER/runs/000012.
QString runFolder(const QString& campaign_folder, int number);

/// Reads the shard files of a folder, in the order of the runs' numbers; of a run that is there twice, the first
/// counts. A last line without its end is left out. Fails on any other line that is no result, with file and line, and
/// on results of another version than `version`.
Result<std::vector<RunResult>> readResults(const QString& folder, const std::string& version,
                                           ResultPart part = ResultPart::Whole);

} // namespace usar::campaign
