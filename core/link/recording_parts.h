// A recording that is cut into parts, so that its oldest can go when a limit of size is reached.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include <sys/stat.h>

#include <QString>

#include "core/base/clock.h"
#include "core/base/result.h"
#include "core/link/recording_format.h"

namespace usar::link {

/// Topic of the note behind which a part tells something new.
inline constexpr std::string_view part_topic = "part";

/// Path of an earlier part of the recording at `path`: "R1.usarrec" becomes "R1.part3.usarrec".
QString partPath(const QString& path, int number);
/// A size as messages about recordings tell it: "12.3 MB".
std::string megabytesText(std::uint64_t bytes);

/// Holds what the name of an earlier part tells. Only the file itself tells whether it is one.
struct PartName {
    QString recording; ///< path of the recording whose part it would be
    int number = 0;
};
std::optional<PartName> readPartPath(const QString& path);
/// The numbers of the files that are named as parts of the recording at `path`, the smallest first.
std::vector<int> partNumbersBeside(const QString& path);

/// Tells which records of a later part only repeat what the parts before it have told. To be asked about every record
/// in order.
class PartSeam {
public:
    bool repeats(const Record& record);

private:
    bool begun_ = false;
    bool repeating_ = false;
    LineNumber line_;
};

/// The parts of one recording on the disk while it is being written. The file at `path` always is the newest part;
/// those before it are renamed. Only files that this object has renamed are ever deleted. Used in one thread, which may
/// have to wait for the disk.
class RecordingParts {
public:
    static constexpr std::uint64_t least_limit_bytes = 10'000'000;
    /// So many parts fit into the limit.
    static constexpr std::uint64_t parts_in_limit = 10;

    /// A part that is gone.
    struct Dropped {
        std::string path;
        bool deleted = true; ///< false: somebody else has moved or deleted it before
        std::uint64_t bytes = 0;
        Seconds end{0.0}; ///< since the beginning of the recording; what was recorded before is gone
    };

    /// Fails if parts of another recording of this name lie there.
    static Result<RecordingParts> at(const QString& path);

    /// Number of the newest part, from 1.
    int number() const { return number_; }
    /// Size of the parts that are on the disk, when the newest has `newest_bytes`.
    std::uint64_t bytes(std::uint64_t newest_bytes) const { return older_bytes_ + newest_bytes; }
    /// True if the newest part is large enough for another to begin. `head_bytes` is the size of what a part repeats;
    /// no part is smaller than twice that.
    static bool isFull(std::uint64_t newest_bytes, std::uint64_t head_bytes, std::uint64_t limit_bytes);
    /// Renames the newest part, of this size and with this end since the recording's beginning, so that its path is
    /// free for the next. `file` is its descriptor, by which it is told from a file that somebody else has put there.
    /// Errors leave everything as it is.
    Result<void> setAside(int file, std::uint64_t newest_bytes, Seconds end);
    /// To be called when the file of that part has been closed, which sets its time on some file systems: from then on
    /// the part is known by this time.
    void noteClosed();
    /// Undoes the last setAside, if the next part could not be begun.
    Result<void> takeBack();
    /// Deletes the oldest part if all parts and another one are more than the limit; nullopt if there is room, or
    /// nothing older than the newest part. To be called until it returns nullopt. The error of a part that cannot be
    /// deleted comes once, and the part counts no more.
    std::optional<Result<Dropped>> makeRoom(std::uint64_t newest_bytes, std::uint64_t limit_bytes);

private:
    /// A part that was renamed.
    struct Older {
        QString path;
        struct stat status = {}; ///< tells whether it is still the same file
        std::uint64_t bytes = 0;
        Seconds end{0.0};
    };
    explicit RecordingParts(QString path) : path_(std::move(path)) {}

    QString path_;
    int number_ = 1;
    std::deque<Older> older_;
    std::uint64_t older_bytes_ = 0;
};

} // namespace usar::link
