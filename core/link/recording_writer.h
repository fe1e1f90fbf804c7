// Writes a recording while it happens, without ever blocking the callers.
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <QString>

#include "core/base/clock.h"
#include "core/base/result.h"
#include "core/link/recording_packing.h"
#include "core/link/recording_parts.h"

namespace usar::link {

struct RecordingLimits {
    std::size_t buffer_bytes = 64u << 20; ///< most bytes that may wait for the disk
    std::chrono::milliseconds flush{250}; ///< longest time for which records wait in the buffer
};

/// Records go into a buffer; a thread of the writer compresses them and hands them to the kernel four times a second,
/// or as soon as 1 MiB waits. So a program that is killed loses a quarter of a second, and a machine that loses power
/// loses what the kernel had not written yet. If the disk is full, or too slow for longer than the buffer lasts, the
/// recording ends: the file then ends with a whole block, and `takeTrouble` gives the reason once. All calls must come
/// from one thread. The file is locked (flock) while it is written, so that its readers can tell. It may be cut into
/// parts (recording_parts.h); the writer's thread renames and deletes them, too.
class RecordingWriter {
public:
    /// Creates the file and missing folders, and writes `facts` as the Start record. `line` is the newest info line. A
    /// file of this name that already exists is left alone and is an error, and so is a part of such a recording.
    static Result<std::unique_ptr<RecordingWriter>> create(const QString& path,
                                                           const std::map<std::string, std::string>& facts,
                                                           LineNumber line, RecordingLimits limits = {});
    ~RecordingWriter(); ///< calls `finish`
    /// Ends the recording properly, for which it waits for the disk, and returns what went wrong since the last call of
    /// `takeTrouble`. Later calls do nothing.
    std::optional<Error> finish();

    /// Queues the record and sets its time to now. Does nothing once the recording has broken off.
    void write(Record record);
    /// `done` is called once everything written so far can be read in the file, or never will be. It runs in the
    /// writer's thread, which it must not block, or at once in the caller's if the recording has broken off.
    void flush(std::function<void()> done);
    /// Calls `write`, which writes what a reader must know at the beginning. These records may be more than the buffer.
    void writeHead(const std::function<void()>& write);

    /// Everything from now on goes into the next part, which begins with these facts; `end` is the time since the
    /// recording began. If it cannot begin, the recording ends. Does nothing while `cutting`.
    void beginPart(const std::map<std::string, std::string>& facts, LineNumber line, Seconds end);
    /// True from `beginPart` until the new part is on the disk with its head.
    bool cutting() const { return cutting_; }
    /// Number of the newest part, from 1.
    int partNumber() const { return number_; }
    /// Deletes the oldest parts soon, as RecordingParts::makeRoom does. Another call replaces the limit of those
    /// before, also while they are being carried out; with nullopt, nothing further is deleted for them.
    void makeRoom(std::optional<std::uint64_t> limit_bytes);
    /// Returns the parts that have gone, or could not be deleted, since the last call.
    std::vector<Result<RecordingParts::Dropped>> takeDropped();

    /// Reason why the recording ended early; nullopt if it has not, and after the first call that gave the reason.
    std::optional<Error> takeTrouble();
    /// True once the recording has ended early or was finished.
    bool broken() const { return broken_; }
    const std::string& path() const { return path_; }
    /// Size of the newest part so far, without what still waits in the buffer.
    std::uint64_t bytes() const { return std::max<std::uint64_t>(bytes_, recording::head_bytes); }
    /// So many of them are what `writeHead` wrote, if it did; 0 until that is on the disk.
    std::uint64_t headBytes() const { return head_bytes_; }
    /// Size of all parts that are on the disk.
    std::uint64_t allBytes();

private:
    /// Describes a part that ends.
    struct Cut {
        PackedBatch last; ///< records
        Seconds end{0.0};
    };
    /// Tells the thread what it has to do next.
    struct Work {
        std::optional<Cut> cut; ///< comes before the records
        PackedBatch records;
        std::optional<std::size_t> head_end; ///< offset in `records` behind the last record of `writeHead`
        bool last = false;
    };

    RecordingWriter(RecordingParts parts, std::string path, int file, RecordingLimits limits);
    void run(std::stop_token stop);
    Work waitForWork(const std::stop_token& stop);
    bool drain(const std::string& batch);
    bool cutHere(Cut cut, std::string& bytes);
    Result<void> beginFile(Seconds end);
    void dropOldest();
    void tellFlushed();
    void breakOff(Error trouble);

    std::string path_;
    int file_;
    RecordingLimits limits_;
    std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
    LineNumber newest_line_;
    int number_ = 1;
    bool in_head_ = false;
    std::atomic<std::uint64_t> bytes_{0};
    std::atomic<std::uint64_t> head_bytes_{0};
    std::atomic<bool> cutting_{false};
    std::atomic<bool> broken_{false};
    std::mutex mutex_; ///< guards the members up to `blocks_`
    std::condition_variable_any wake_;
    RecordPacker waiting_;
    std::size_t free_waiting_ = 0; ///< bytes that wait and do not count against the buffer
    std::optional<Cut> cut_;
    std::optional<std::size_t> head_end_;          ///< as in Work, in `waiting_`
    std::optional<std::uint64_t> limit_bytes_;     ///< for which room is to be made
    std::optional<std::uint64_t> now_limit_bytes_; ///< for which room is being made
    std::vector<Result<RecordingParts::Dropped>> dropped_;
    std::uint64_t older_bytes_ = 0; ///< size of the parts before the newest
    std::vector<std::function<void()>> on_flushed_;
    std::optional<Error> trouble_;
    std::optional<BlockWriter> blocks_; ///< used by the writer's thread only, like the next two
    RecordingParts parts_;
    std::vector<std::function<void()>> now_flushed_;
    std::jthread thread_; ///< declared last, so that it ends before what it uses
};

} // namespace usar::link
