#include "core/campaign/runs/shard_file.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <map>
#include <vector>

#include <sys/file.h>
#include <unistd.h>

#include <QDir>

#include "core/campaign/runs/parallel.h"

namespace usar::campaign {

namespace {

/// Removes what stands after the last line end.
Result<void> dropTornLine(QFile& file) {
    constexpr qint64 step = 1 << 16;
    qint64 end = file.size();
    while (end > 0) {
        const qint64 begin = std::max(qint64(0), end - step);
        file.seek(begin);
        const qsizetype last = file.read(end - begin).lastIndexOf('\n');
        if (last >= 0) {
            end = begin + last + 1;
            break;
        }
        end = begin;
    }
    if (end != file.size() && !file.resize(end))
        return failure("a line that was cut off cannot be removed: " + file.errorString().toStdString(),
                       file.fileName().toStdString(), "Check the permissions");
    return {};
}

constexpr qint64 block_bytes = qint64{4} << 20;

/// Reads the lines on all processors, because no other step of going on with a campaign takes as long.
std::vector<Result<RunResult>> readLines(const std::vector<QByteArray>& lines, ResultPart part) {
    std::vector<Result<RunResult>> results(lines.size());
    inParallel(lines.size(), [&](std::size_t line) { results[line] = readResultLine(lines[line], part); });
    return results;
}

/// `place` is the file and the line.
Result<void> takeResult(Result<RunResult>&& result, const std::string& version, const std::string& place,
                        std::map<int, RunResult>& results) {
    if (!result)
        return failure(result.error().what, place, "Remove the line; its run will be flown again with --resume");
    if (result->version != version)
        return failure("this result is of version " + result->version + ", and this program is " + version, place,
                       "Use that version, or begin anew in another folder");
    const int number = result->number;
    results.try_emplace(results.end(), number, *std::move(result)); // They are nearly in order.
    return {};
}

Result<void> readFile(const QString& path, const std::string& version, ResultPart part,
                      std::map<int, RunResult>& results) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return failure("cannot read it: " + file.errorString().toStdString(), path.toStdString(),
                       "Check the permissions");
    QByteArray text;
    int number = 0;
    while (!file.atEnd()) {
        const QByteArray block = file.read(block_bytes);
        if (block.isEmpty())
            break;
        text += block;
        std::vector<QByteArray> lines;
        qsizetype begin = 0;
        for (qsizetype end = 0; (end = text.indexOf('\n', begin)) >= 0; begin = end + 1)
            lines.push_back(QByteArray::fromRawData(text.constData() + begin, end - begin));
        for (Result<RunResult>& result : readLines(lines, part))
            if (auto taken = takeResult(std::move(result), version, path.toStdString() + ':' + std::to_string(++number),
                                        results);
                !taken)
                return taken;
        text.remove(0, begin);
    }
    return {};
}

/// Writes all of it; otherwise returns what the kernel says of the byte that it does not take. QFile has no words for a
/// disk that fills up in the middle of a line.
std::string troubleWriting(const QByteArray& bytes, int handle) {
    for (qsizetype done = 0; done < bytes.size();) {
        const ssize_t written =
            ::write(handle, bytes.constData() + done, static_cast<std::size_t>(bytes.size() - done));
        if (written < 0 && errno != EINTR)
            return std::strerror(errno);
        done += std::max<ssize_t>(written, 0);
    }
    return {};
}

} // namespace

Result<ShardFile> ShardFile::open(const QString& folder, const Shard& shard) {
    const QString path = QDir(folder).filePath(QString("shard-%1.jsonl").arg(shard.index, 3, 10, QChar('0')));
    auto file = std::make_unique<QFile>(path);
    if (!file->open(QIODevice::ReadWrite | QIODevice::Append))
        return failure("the results cannot be written: " + file->errorString().toStdString(), path.toStdString(),
                       "Give another folder with --out");
    if (::flock(file->handle(), LOCK_EX | LOCK_NB) != 0)
        return failure(errno == EWOULDBLOCK ? std::string("another program is writing these results")
                                            : std::string("the results cannot be locked: ") + std::strerror(errno),
                       path.toStdString(), "Wait for it, or give another folder with --out");
    auto division = Division::take(folder, shard.of);
    if (!division)
        return tl::unexpected(division.error());
    if (const auto dropped = dropTornLine(*file); !dropped)
        return tl::unexpected(dropped.error());
    return ShardFile(std::move(file), *std::move(division));
}

Result<void> ShardFile::append(const RunResult& result) {
    const std::string trouble = troubleWriting(toLine(result), file_->handle());
    if (trouble.empty())
        return {};
    return failure("a result cannot be written: " + trouble, file_->fileName().toStdString(),
                   "Make room and go on with --resume; this run will be flown again");
}

QString runFolder(const QString& campaign_folder, int number) {
    return QDir(campaign_folder).filePath(QString("runs/%1").arg(number, 6, 10, QChar('0')));
}

Result<std::vector<RunResult>> readResults(const QString& folder, const std::string& version, ResultPart part) {
    std::map<int, RunResult> results;
    const QDir dir(folder);
    for (const QString& name : dir.entryList({"shard-*.jsonl"}, QDir::Files, QDir::Name))
        if (const auto read = readFile(dir.filePath(name), version, part, results); !read)
            return tl::unexpected(read.error());
    std::vector<RunResult> all;
    for (auto& [number, result] : results)
        all.push_back(std::move(result));
    return all;
}

} // namespace usar::campaign
