// The history of a run, from its trace: gives the activity of all places at any moment, and quickly even for a long
// run.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/posh/trace/run_activity.h"
#include "core/posh/trace/trace_file.h"

namespace usar::posh {

/// One cycle of a run.
struct RunMoment {
    std::uint64_t cycle = 0;  ///< number of the cycle
    std::int64_t time_ms = 0; ///< in the engine's time
    std::size_t bytes = 0;    ///< length of the trace when the cycle became known
};

/// Owns the trace, which may grow while it is used. It stores the activity at up to 64 evenly spread moments (fewer for
/// a large plan), so that any other moment can be computed from a near one. For use in one thread.
class RunHistory {
public:
    RunHistory() = default;
    RunHistory(const RunHistory&) = delete;
    RunHistory& operator=(const RunHistory&) = delete;

    void clear();
    /// Adds the next piece of the trace. A piece that begins with the magic of a trace file starts another run.
    void append(std::string_view piece);
    const std::string& bytes() const { return bytes_; }
    /// Describes what is wrong with the trace; empty if nothing is.
    std::string damage() const { return file_ ? file_->damage() : std::string(); }

    /// All moments in order, one for each cycle. The functions below take indices of this list.
    const std::vector<RunMoment>& moments() const { return moments_; }
    /// Returns the last moment that is not after that time, or 0 if all are after it. There must be at least one
    /// moment.
    std::size_t momentAt(std::int64_t time_ms) const;

    /// The activity after the last moment.
    const RunActivity& newest() const { return newest_; }
    /// Returns the activity after the cycle of a moment or, if an epoch is given (counting from 0), after that epoch of
    /// the cycle. An epoch past the last means the last.
    RunActivity at(std::size_t moment, std::optional<std::size_t> epoch = {}) const;
    /// Returns the number of epochs (decisions) in the cycle of a moment: one, plus one after every act that took no
    /// time.
    std::size_t epochCount(std::size_t moment) const;
    /// Returns the text of the plan that ran at a moment.
    const std::string& planText(std::size_t moment) const;

private:
    struct Remembered {
        std::size_t cycles = 0; ///< number of cycles after which the activity was stored
        RunActivity activity;
    };
    void readOn();
    void remember();
    Remembered nearestTo(std::size_t cycles) const;
    TraceFile::Cursor cursorAt(std::size_t moment) const { return file_->seek(moments_[moment].cycle); }
    /// Feeds a cycle to the activity.
    static void fold(RunActivity& activity, const TracedCycle& cycle);
    /// Returns the ends of the epochs as indices in the events of the cycle.
    static std::vector<std::size_t> epochEnds(const TracedCycle& cycle);

    std::string bytes_;
    std::optional<TraceFile> file_; ///< refers to `bytes_`; nullopt before the first piece
    std::optional<TraceFile::Cursor> cursor_;
    std::vector<RunMoment> moments_;
    std::vector<Remembered> remembered_;
    std::size_t every_ = 256; ///< number of moments between two stored ones
    RunActivity newest_;
    mutable std::optional<Remembered> last_asked_; ///< cache, because users step from one moment to the next
};

} // namespace usar::posh
