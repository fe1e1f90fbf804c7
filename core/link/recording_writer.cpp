#include "core/link/recording_writer.h"

#include <cerrno>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <QDir>
#include <QFileInfo>

namespace usar::link {

namespace {

constexpr std::size_t batch_bytes = 1u << 20; ///< this much wakes the thread early

Error writingTrouble(int error, const std::string& path, std::uint64_t written) {
    const bool full = error == ENOSPC || error == EDQUOT || error == EFBIG;
    return {(full ? std::string("there is no room left") : std::string(std::strerror(error))) +
                ", so the recording ends after " + megabytesText(written) + "; the mission goes on",
            path, full ? "Free some room, or choose another folder, and record again" : "Record to another folder"};
}

std::string startText(const std::map<std::string, std::string>& facts) {
    std::string text;
    for (const auto& [key, value] : facts)
        text += key + ": " + value + '\n';
    return text;
}

/// Takes the first bytes out of the batch; they end with a whole record.
PackedBatch takeFirst(PackedBatch& batch, std::size_t size) {
    if (size == batch.bytes.size())
        return std::exchange(batch, {});
    PackedBatch first;
    first.bytes = batch.bytes.substr(0, size);
    batch.bytes.erase(0, size);
    const auto behind = std::ranges::lower_bound(batch.groups, size);
    first.groups.assign(batch.groups.begin(), behind);
    batch.groups.erase(batch.groups.begin(), behind);
    for (std::size_t& group : batch.groups)
        group -= size;
    return first;
}

/// Closes a file and returns 0 or the error: on some file systems only this tells that bytes were not written.
int closeFile(int file) {
    return ::close(file) == 0 || errno == EINTR ? 0 : errno;
}

/// Locks the file of a recording. Without the lock, readers take an unfinished end for a broken one. A reader that
/// looks whether it is locked has a lock of its own for a moment, so that a few milliseconds are enough.
void lockFile(int file) {
    constexpr int tries = 20;
    for (int i = 0; i < tries && ::flock(file, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK; ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

/// Creates the file of a recording, and locks it.
Result<int> createFile(const std::string& path) {
    const int file =
        ::open(QString::fromStdString(path).toLocal8Bit().constData(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644);
    if (file < 0 && errno == EEXIST)
        return failure("there is a file of this name already, and it is left alone", path,
                       "Give the recording another name");
    if (file < 0)
        return failure(std::string("the recording cannot be written: ") + std::strerror(errno), path,
                       "Record to another folder");
    lockFile(file);
    return file;
}

} // namespace

Result<std::unique_ptr<RecordingWriter>> RecordingWriter::create(const QString& path,
                                                                 const std::map<std::string, std::string>& facts,
                                                                 LineNumber line, RecordingLimits limits) {
    auto parts = RecordingParts::at(path);
    if (!parts)
        return tl::unexpected(parts.error());
    QDir().mkpath(QFileInfo(path).absolutePath());
    const auto file = createFile(path.toStdString());
    if (!file)
        return tl::unexpected(file.error());
    std::unique_ptr<RecordingWriter> writer(new RecordingWriter(*std::move(parts), path.toStdString(), *file, limits));
    writer->write({.kind = RecordKind::Start, .line = line, .bytes = startText(facts)});
    return writer;
}

RecordingWriter::RecordingWriter(RecordingParts parts, std::string path, int file, RecordingLimits limits)
    : path_(std::move(path))
    , file_(file)
    , limits_(limits)
    , blocks_(recording::head_bytes)
    , parts_(std::move(parts)) {
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
    if (const int error = file_ < 0 ? 0 : closeFile(file_); error != 0) {
        const std::lock_guard lock(mutex_);
        breakOff(writingTrouble(error, path_, bytes_));
    }
    auto trouble = takeTrouble();
    broken_ = true;
    return trouble;
}

void RecordingWriter::write(Record record) {
    record.time = std::chrono::steady_clock::now() - began_;
    newest_line_ = record.line;
    const std::lock_guard lock(mutex_);
    if (broken_)
        return;
    const std::size_t before = waiting_.size();
    const std::size_t all_before = before + (cut_ ? cut_->last.bytes.size() : 0) - free_waiting_;
    if (!in_head_ && all_before + record.bytes.size() > limits_.buffer_bytes)
        return breakOff({"the disk is too slow for what comes, so the recording ends here; the mission goes on", path_,
                         "Record to a faster disk, or run slower"});
    waiting_.add(record);
    if (in_head_)
        free_waiting_ += waiting_.size() - before;
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

void RecordingWriter::writeHead(const std::function<void()>& write) {
    in_head_ = true;
    write();
    in_head_ = false;
    const std::lock_guard lock(mutex_);
    if (broken_)
        return;
    head_end_ = waiting_.size();
    wake_.notify_one();
}

void RecordingWriter::beginPart(const std::map<std::string, std::string>& facts, LineNumber line, Seconds end) {
    if (cutting_)
        return;
    write({.kind = RecordKind::End, .line = line});
    {
        const std::lock_guard lock(mutex_);
        if (broken_)
            return;
        cut_ = Cut{waiting_.take(), end};
        waiting_ = {};
        head_end_.reset(); // That of the part that ends.
        cutting_ = true;
        wake_.notify_one();
    }
    ++number_;
    began_ = std::chrono::steady_clock::now();
    write({.kind = RecordKind::Start, .line = line, .bytes = startText(facts)});
}

void RecordingWriter::makeRoom(std::optional<std::uint64_t> limit_bytes) {
    const std::lock_guard lock(mutex_);
    limit_bytes_ = limit_bytes;
    if (now_limit_bytes_)
        now_limit_bytes_ = limit_bytes;
    wake_.notify_one();
}

std::vector<Result<RecordingParts::Dropped>> RecordingWriter::takeDropped() {
    const std::lock_guard lock(mutex_);
    return std::exchange(dropped_, {});
}

std::uint64_t RecordingWriter::allBytes() {
    const std::lock_guard lock(mutex_);
    return older_bytes_ + bytes();
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

RecordingWriter::Work RecordingWriter::waitForWork(const std::stop_token& stop) {
    Work work;
    std::unique_lock lock(mutex_);
    wake_.wait_for(lock, stop, limits_.flush, [this] {
        return waiting_.size() >= batch_bytes || !on_flushed_.empty() || cut_ || head_end_ || limit_bytes_;
    });
    work.last = stop.stop_requested();
    work.cut = std::exchange(cut_, std::nullopt);
    work.records = waiting_.take();
    work.head_end = std::exchange(head_end_, std::nullopt);
    free_waiting_ = 0;
    now_limit_bytes_ = std::exchange(limit_bytes_, std::nullopt);
    now_flushed_.swap(on_flushed_);
    return work;
}

void RecordingWriter::run(std::stop_token stop) {
    std::string bytes;
    recording::appendHead(bytes);
    bool last = false;
    while (!last && !broken_) {
        Work work = waitForWork(stop);
        last = work.last;
        if (work.cut && !cutHere(*std::move(work.cut), bytes))
            break;
        std::uint64_t head_bytes = 0;
        if (work.head_end) {
            blocks_->append(bytes, takeFirst(work.records, *work.head_end));
            head_bytes = bytes_ + bytes.size();
        }
        blocks_->append(bytes, std::move(work.records));
        if (last)
            blocks_->appendIndex(bytes);
        if (!drain(bytes))
            break;
        if (head_bytes > 0) {
            head_bytes_ = head_bytes;
            cutting_ = false;
        }
        dropOldest();
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

/// Ends the file, behind `bytes` that are still to be written into it, and begins the next one.
bool RecordingWriter::cutHere(Cut cut, std::string& bytes) {
    blocks_->append(bytes, std::move(cut.last));
    blocks_->appendIndex(bytes);
    if (!drain(bytes))
        return false;
    if (auto begun = beginFile(cut.end); !begun) {
        const std::lock_guard lock(mutex_);
        Error error = begun.error();
        error.what = "the recording ends, because its next part cannot begin: " + error.what + "; the mission goes on";
        breakOff(std::move(error));
        return false;
    }
    bytes.clear();
    recording::appendHead(bytes);
    blocks_.emplace(recording::head_bytes);
    return true;
}

Result<void> RecordingWriter::beginFile(Seconds end) {
    if (auto aside = parts_.setAside(file_, bytes_, end); !aside)
        return aside;
    const int error_at_end = closeFile(std::exchange(file_, -1));
    parts_.noteClosed();
    const Result<int> file =
        error_at_end == 0
            ? createFile(path_)
            : Result<int>(tl::unexpect, Error{std::string("the part before it could not be written to its end: ") +
                                                  std::strerror(error_at_end),
                                              path_, "Record to another folder"});
    if (!file) {
        Error error = file.error();
        if (const auto back = parts_.takeBack(); !back)
            error.what += "; " + back.error().text();
        return tl::unexpected(error);
    }
    file_ = *file;
    const std::lock_guard lock(mutex_);
    older_bytes_ = parts_.bytes(0);
    bytes_ = 0;
    return {};
}

/// Looks at the limit before each part, for the user may raise it while the disk is busy.
void RecordingWriter::dropOldest() {
    const auto now_limit_bytes = [this] {
        const std::lock_guard lock(mutex_);
        return now_limit_bytes_;
    };
    while (const auto limit_bytes = now_limit_bytes()) {
        auto dropped = parts_.makeRoom(bytes_, *limit_bytes);
        const std::lock_guard lock(mutex_);
        if (!dropped) {
            now_limit_bytes_.reset();
            return;
        }
        dropped_.push_back(*std::move(dropped));
        older_bytes_ = parts_.bytes(0);
    }
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

/// The first trouble is the reason; what follows may only come of it.
void RecordingWriter::breakOff(Error trouble) {
    if (!broken_)
        trouble_ = std::move(trouble);
    broken_ = true;
    waiting_.take();
    free_waiting_ = 0;
    cut_.reset();
    head_end_.reset();
}

} // namespace usar::link
