// Follows the results of a campaign while another process writes them.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include <QString>

#include "core/base/result.h"
#include "core/campaign/runs/run_result.h"

namespace usar::campaign {

/// Reads what was added to the shard files of a folder since the last time. A plain value; not for use by several
/// threads at once. Results of any version are read: they are to be looked at, not to be gone on with.
class ResultTail {
public:
    explicit ResultTail(QString folder) : folder_(std::move(folder)) {}

    /// Returns new results, at most so many. A last line without its end waits for the rest of it; of a run that is
    /// there twice, the first counts. A folder without shard files has no results. The error names file and line; it
    /// waits for the next call if there are results to return.
    Result<std::vector<RunResult>> take(std::size_t most);

private:
    /// How far a file was read.
    struct Place {
        qint64 offset_bytes = 0;
        int lines = 0;
    };

    Result<void> read(const QString& path, std::size_t most, std::vector<RunResult>& results);

    QString folder_;
    std::map<QString, Place> places_; ///< They are found by the path of the shard file.
    std::set<int> seen_;              ///< These runs were returned.
    std::optional<Error> trouble_;    ///< The next call returns it.
};

} // namespace usar::campaign
