#include "core/campaign/runs/result_tail.h"

#include <utility>

#include <QDir>
#include <QFile>

namespace usar::campaign {

Result<std::vector<RunResult>> ResultTail::take(std::size_t most) {
    if (const auto trouble = std::exchange(trouble_, std::nullopt))
        return tl::unexpected(*trouble);
    std::vector<RunResult> results;
    const QDir folder(folder_);
    for (const QString& name : folder.entryList({"shard-*.jsonl"}, QDir::Files, QDir::Name))
        if (const auto read_well = read(folder.filePath(name), most, results); !read_well && !trouble_)
            trouble_ = read_well.error();
    if (trouble_ && results.empty())
        return tl::unexpected(*std::exchange(trouble_, std::nullopt));
    return results; // What was read counts as seen and does not come again, so an error waits for the next call.
}

Result<void> ResultTail::read(const QString& path, std::size_t most, std::vector<RunResult>& results) {
    QFile file(path);
    Place& place = places_[path];
    if (!file.open(QIODevice::ReadOnly) || !file.seek(place.offset_bytes))
        return failure("cannot be read: " + file.errorString().toStdString(), path.toStdString(),
                       "Check the permissions");
    while (results.size() < most) {
        const QByteArray line = file.readLine();
        if (!line.endsWith('\n'))
            break;
        auto result = readResultLine(line);
        if (!result)
            return failure(result.error().what, path.toStdString() + ':' + std::to_string(place.lines + 1),
                           "Remove this line; its run is then flown again");
        place.offset_bytes += line.size();
        ++place.lines;
        if (seen_.insert(result->number).second)
            results.push_back(*std::move(result));
    }
    return {};
}

} // namespace usar::campaign
