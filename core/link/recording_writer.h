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

namespace usar::link {

struct RecordingLimits {
    std::size_t buffer_bytes = 64u << 20; ///< most bytes that may wait for the disk
    std::chrono::milliseconds flush{250}; ///< longest time for which records wait in the buffer
};

/// Records go into a buffer; a thread of the writer compresses them and hands them to the kernel four times a second,
/// or as soon as 1 MiB waits. So a program that is killed loses a quarter of a second, and a machine that loses power
/// loses what the kernel had not written yet. If the disk is full, or too slow for longer than the buffer lasts, the
/// recording ends: the file then ends with a whole block, and `takeTrouble` gives the reason once. All calls must come
/// from one thread. The file is locked (flock) while it is written, so that its readers can tell.
class RecordingWriter {
public:
    /// Creates the file and missing folders, and writes `facts` as the Start record. `line` is the newest info line. A
    /// file of this name that already exists is left alone and is an error.
    static Result<std::unique_ptr<RecordingWriter>> create(const QString& path,
                                                           const std::map<std::string, std::string>& facts,
                                                           LineNumber line, RecordingLimits limits = {});
    ~RecordingWriter(); ///< calls `finish`
    /// Ends the recording properly, waiting for the disk, and returns what went wrong since `takeTrouble`. Later calls
    /// do nothing.
    std::optional<Error> finish();

    /// Queues the record and sets its time to now. Does nothing once the recording has broken off.
    void write(Record record);
    /// `done` is called once everything written so far can be read in the file, or never will be. It runs in the
    /// writer's thread, which it must not block, or at once in the caller's if the recording has broken off.
    void flush(std::function<void()> done);
    /// Reason why the recording ended early; nullopt if it has not, and after the first call that gave the reason.
    std::optional<Error> takeTrouble();
    /// True once the recording has ended early or was finished.
    bool broken() const { return broken_; }
    const std::string& path() const { return path_; }
    /// Size of the file so far, without what still waits in the buffer.
    std::uint64_t bytes() const { return std::max<std::uint64_t>(bytes_, recording::head_bytes); }

private:
    RecordingWriter(std::string path, int file, RecordingLimits limits);
    void run(std::stop_token stop);
    bool drain(const std::string& batch);
    void tellFlushed();
    void breakOff(Error trouble);

    std::string path_;
    int file_;
    RecordingLimits limits_;
    std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
    LineNumber newest_line_;
    std::atomic<std::uint64_t> bytes_{0};
    std::atomic<bool> broken_{false};
    std::mutex mutex_; ///< guards the next four members
    std::condition_variable_any wake_;
    RecordPacker waiting_;
    std::vector<std::function<void()>> on_flushed_;
    std::optional<Error> trouble_;
    BlockWriter blocks_; ///< used by the writer's thread only, like the next one
    std::vector<std::function<void()>> now_flushed_;
    std::jthread thread_; ///< declared last, so that it ends before what it uses
};

} // namespace usar::link
