// Writes a recording as it happens, without ever holding up who speaks.
#pragma once

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
#include "core/link/recording_format.h"

namespace usar::link {

struct RecordingLimits {
    std::size_t buffer_bytes = 64u << 20;
    std::chrono::milliseconds flush{250};
};

/// Records go into a buffer; a thread of the writer's own hands them to the kernel four times a second, or as soon as a
/// MiB waits. So a program that is killed loses a quarter of a second, and a machine that loses its power what the
/// kernel had not written yet. A disk that is full, or slower than what comes for longer than the buffer lasts, ends
/// the recording: the file then ends with a whole record, and `takeTrouble` says why, once. Calls come from one thread.
/// The file is locked (flock) while it is written, so that its readers know.
class RecordingWriter {
public:
    /// A file of this name that exists is left alone: an error. Folders on the way to it are made.
    static Result<std::unique_ptr<RecordingWriter>> create(const QString& path,
                                                           const std::map<std::string, std::string>& facts,
                                                           LineNumber line, RecordingLimits limits = {});
    /// Ends the recording in order.
    ~RecordingWriter();

    /// The record's time is set to now.
    void write(Record record);
    /// `done` is called once all that was written until now can be read in the file, or never will be: by the writer's
    /// thread, which it must not hold up.
    void flush(std::function<void()> done);
    /// Why the recording ended before its time; once.
    std::optional<Error> takeTrouble();
    bool broken() const { return broken_; }
    const std::string& path() const { return path_; }
    Seconds elapsed() const { return std::chrono::steady_clock::now() - began_; }
    /// Of the file so far, with what still waits in the buffer.
    std::uint64_t bytes() const { return bytes_; }

private:
    RecordingWriter(std::string path, int file, RecordingLimits limits);
    void run(std::stop_token stop);
    bool drain(std::string& batch);
    void tellFlushed();
    void breakOff(Error trouble);

    std::string path_;
    int file_;
    RecordingLimits limits_;
    std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
    LineNumber newest_line_;
    std::atomic<std::uint64_t> bytes_{0};
    std::atomic<bool> broken_{false};
    std::mutex mutex_; ///< of the next four
    std::condition_variable_any wake_;
    std::string waiting_;
    std::vector<std::function<void()>> on_flushed_;
    std::optional<Error> trouble_;
    std::uint64_t written_bytes_ = 0;                ///< the thread's own
    std::vector<std::function<void()>> now_flushed_; ///< likewise
    std::jthread thread_;                            ///< last, so that it ends before what it uses
};

} // namespace usar::link
