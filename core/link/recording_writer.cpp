#include "core/link/recording_writer.h"

#include <cerrno>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <QDir>
#include <QFileInfo>

#include "core/base/numbers.h"

namespace usar::link {

namespace {

constexpr std::size_t batch_bytes = 1u << 20; ///< this much wakes the thread early

std::string megabytes(std::uint64_t bytes) {
    return fixed(static_cast<double>(bytes) / 1e6, 1) + " MB";
}

Error writingTrouble(int error, const std::string& path, std::uint64_t written) {
    const bool full = error == ENOSPC || error == EDQUOT || error == EFBIG;
    return {(full ? std::string("there is no room left") : std::string(std::strerror(error))) +
                ", so the recording ends after " + megabytes(written) + "; the mission goes on",
            path, full ? "Free some room, or choose another folder, and record again" : "Record to another folder"};
}

} // namespace

Result<std::unique_ptr<RecordingWriter>> RecordingWriter::create(const QString& path,
                                                                 const std::map<std::string, std::string>& facts,
                                                                 LineNumber line, RecordingLimits limits) {
    QDir().mkpath(QFileInfo(path).absolutePath());
    const int file = ::open(path.toLocal8Bit().constData(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644);
    if (file < 0 && errno == EEXIST)
        return failure("there is a file of this name already, and it is left alone", path.toStdString(),
                       "Give the recording another name");
    if (file < 0)
        return failure(std::string("the recording cannot be written: ") + std::strerror(errno), path.toStdString(),
                       "Record to another folder");
    (void)::flock(file, LOCK_EX | LOCK_NB); // Without the lock, readers take an unfinished end for a broken one.
    std::unique_ptr<RecordingWriter> writer(new RecordingWriter(path.toStdString(), file, limits));
    std::string text;
    for (const auto& [key, value] : facts)
        text += key + ": " + value + '\n';
    writer->write({.kind = RecordKind::Start, .line = line, .bytes = text});
    return writer;
}

RecordingWriter::RecordingWriter(std::string path, int file, RecordingLimits limits)
    : path_(std::move(path))
    , file_(file)
    , limits_(limits)
    , blocks_(recording::head_bytes) {
    thread_ = std::jthread([this](std::stop_token stop) { run(std::move(stop)); });
}

RecordingWriter::~RecordingWriter() {
    finish();
}

std::optional<Error> RecordingWriter::finish() {
    if (!thread_.joinable())
        return std::nullopt;
    write({.kind = RecordKind::End, .line = newest_line_});
    thread_.request_stop();
    wake_.notify_all();
    thread_.join();
    ::close(file_);
    auto trouble = takeTrouble();
    broken_ = true;
    return trouble;
}

void RecordingWriter::write(Record record) {
    if (broken_)
        return;
    record.time = std::chrono::steady_clock::now() - began_;
    newest_line_ = record.line;
    const std::lock_guard lock(mutex_);
    const std::size_t before = waiting_.size();
    if (before + record.bytes.size() > limits_.buffer_bytes)
        return breakOff({"the disk is too slow for what comes, so the recording ends here; the mission goes on", path_,
                         "Record to a faster disk, or run slower"});
    waiting_.add(record);
    if (waiting_.size() >= batch_bytes && before < batch_bytes)
        wake_.notify_one();
}

void RecordingWriter::flush(std::function<void()> done) {
    {
        const std::lock_guard lock(mutex_);
        if (!broken_) {
            on_flushed_.push_back(std::move(done));
            wake_.notify_one();
            return;
        }
    }
    done();
}

void RecordingWriter::tellFlushed() {
    for (const auto& done : std::exchange(now_flushed_, {}))
        done();
}

std::optional<Error> RecordingWriter::takeTrouble() {
    if (!broken_)
        return std::nullopt;
    const std::lock_guard lock(mutex_);
    return std::exchange(trouble_, std::nullopt);
}

void RecordingWriter::run(std::stop_token stop) {
    std::string bytes;
    recording::appendHead(bytes);
    bool last = false;
    while (!last && !broken_) {
        PackedBatch batch;
        {
            std::unique_lock lock(mutex_);
            wake_.wait_for(lock, stop, limits_.flush,
                           [this] { return waiting_.size() >= batch_bytes || !on_flushed_.empty(); });
            last = stop.stop_requested();
            batch = waiting_.take();
            now_flushed_.swap(on_flushed_);
        }
        blocks_.append(bytes, std::move(batch));
        if (last)
            blocks_.appendIndex(bytes);
        if (drain(bytes))
            tellFlushed();
        bytes.clear();
    }
    tellFlushed(); // Also if the file has broken off.
    {
        const std::lock_guard lock(mutex_); // Broken or over: no further flush is requested.
        now_flushed_.swap(on_flushed_);
    }
    tellFlushed();
}

/// Writes blocks to the file, the first time behind the file's head. If only a part could be written, cuts the file
/// back to the last whole block.
bool RecordingWriter::drain(const std::string& batch) {
    std::size_t done = 0;
    while (done < batch.size()) {
        const ssize_t count = ::write(file_, batch.data() + done, batch.size() - done);
        if (count < 0 && errno == EINTR)
            continue;
        if (count < 0) {
            const int error = errno;
            std::size_t whole = bytes_ == 0 ? recording::head_bytes : 0;
            while (const auto size = recording::blockSizeAt(std::string_view(batch).substr(whole))) {
                if (whole + *size > done)
                    break;
                whole += *size;
            }
            if (whole <= done && ::ftruncate(file_, static_cast<off_t>(bytes_ + whole)) != 0)
                whole = done; // In this case the reader skips the incomplete block.
            const std::lock_guard lock(mutex_);
            breakOff(writingTrouble(error, path_, bytes_ + whole));
            return false;
        }
        done += static_cast<std::size_t>(count);
    }
    bytes_ += batch.size();
    return true;
}

void RecordingWriter::breakOff(Error trouble) {
    trouble_ = std::move(trouble);
    broken_ = true;
    waiting_.take();
}

} // namespace usar::link
