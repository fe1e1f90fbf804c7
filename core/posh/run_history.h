// A run from its trace: what each place of the plan had done by any moment of it, quickly also in a long run.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/posh/run_activity.h"
#include "core/posh/trace_file.h"

namespace usar::posh {

/// One cycle of a run.
struct RunMoment {
    std::uint64_t cycle = 0;
    std::int64_t time_ms = 0; ///< as the engine counts
    std::size_t bytes = 0;    ///< of the trace, up to which it was known
};

/// Owns the trace and grows with it. So that no moment is far from one that is remembered, it keeps the activity at up
/// to 64 of them, evenly spread; at fewer where the plan is large.
class RunHistory {
public:
    RunHistory() = default;
    RunHistory(const RunHistory&) = delete;
    RunHistory& operator=(const RunHistory&) = delete;

    void clear();
    /// The next piece of the trace; one that begins as a trace file begins another run.
    void append(std::string_view piece);
    const std::string& bytes() const { return bytes_; }
    /// What is wrong with the trace; empty: nothing.
    std::string damage() const { return file_ ? file_->damage() : std::string(); }

    /// One for each cycle, in order.
    const std::vector<RunMoment>& moments() const { return moments_; }
    /// The last one not after that time; the first where all are; there must be one.
    std::size_t momentAt(std::int64_t time_ms) const;

    /// Behind the last of them.
    const RunActivity& newest() const { return newest_; }
    /// Behind that moment's cycle; with an epoch (from 0): behind that epoch of it.
    RunActivity at(std::size_t moment, std::optional<std::size_t> epoch = {}) const;
    /// How often its cycle asked and decided: once, and once more behind every act that took no time.
    std::size_t epochCount(std::size_t moment) const;
    /// What the plan that ran then was read from.
    const std::string& planText(std::size_t moment) const;

private:
    struct Remembered {
        std::size_t cycles = 0; ///< so many are over
        RunActivity activity;
    };
    void readOn();
    void remember();
    Remembered nearestTo(std::size_t cycles) const;
    TraceFile::Cursor cursorAt(std::size_t moment) const { return file_->seek(moments_[moment].cycle); }
    static void fold(RunActivity& activity, const TracedCycle& cycle);
    static std::vector<std::size_t> epochEnds(const TracedCycle& cycle);

    std::string bytes_;
    std::optional<TraceFile> file_; ///< over `bytes_`
    std::optional<TraceFile::Cursor> cursor_;
    std::vector<RunMoment> moments_;
    std::vector<Remembered> remembered_;
    std::size_t every_ = 256; ///< moments between two that are remembered
    RunActivity newest_;
    mutable std::optional<Remembered> last_asked_; ///< people step from it
};

} // namespace usar::posh
