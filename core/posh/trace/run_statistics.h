// Counts of what happened at each place of a plan, over one run or many.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "core/posh/run/trace_event.h"

namespace usar::posh {

/// The counts of one place. Only those that fit the kind of the place are used.
struct PlaceCounts {
    std::uint64_t asked = 0;   ///< evaluations of a sense at this place, including cached answers
    std::uint64_t held = 0;    ///< those after which the sense held
    std::uint64_t started = 0; ///< starts of a drive, selections of an element, entries of a form, inits of an act
    std::uint64_t succeeded = 0;
    std::uint64_t failed = 0;
    std::uint64_t interrupted = 0; ///< for an act, also when it ended because of a goal or a stop
    std::uint64_t skipped = 0;     ///< how often its frequency, its retries or the user held it back
    std::uint64_t runs = 0;        ///< how often an act was run
    /// Time during which this was the active act, in milliseconds of the engine's time: from each cycle in which it was
    /// the last act run to the next cycle. For places above an act, the sum over all acts below.
    std::int64_t active_ms = 0;
    std::uint64_t spent_ns = 0;   ///< total duration of an act's runs; 0 if the engine has no clock
    std::uint64_t longest_ns = 0; ///< duration of the longest of them
    std::uint64_t last_cycle = 0; ///< number of the last cycle with an event here
};

/// The switches between two drives.
struct Alternation {
    int most = 0;            ///< greatest number of switches within alternation_within_ms
    std::uint64_t cycle = 0; ///< number of the cycle with the last of these switches
};

/// Counts the events of a run. Several runs of the same plan add up; another plan resets the counts. Records of places
/// that the plan does not have, which a damaged trace may contain, are ignored.
class RunStatistics final : public TraceObserver {
public:
    /// The time window in which switches between two drives are counted.
    static constexpr std::int64_t alternation_within_ms = 10'000;

    /// Keeps the counts if the program has the same places with the same names as the one before.
    void takeProgram(const std::shared_ptr<const Program>& program) override;
    /// Continues with a program of the same shape (see sameShape), even if its names differ.
    void retune(const std::shared_ptr<const Program>& program) { program_ = program; }
    void take(const TraceRecord& record, std::string_view text) override;
    /// Adds the counts of other runs. Returns false and adds nothing if they are those of a plan with other places.
    bool add(const RunStatistics& other);

    /// The plan whose runs are counted; nullptr before the first.
    const std::shared_ptr<const Program>& program() const { return program_; }
    std::uint64_t cycles() const { return cycles_; }
    const PlaceCounts& at(Index place) const { return counts_[place]; }
    /// Keyed by the places of two drives, the smaller first.
    const std::map<std::pair<Index, Index>, Alternation>& alternations() const { return alternations_; }
    /// How often each drive was reported as starving, by its place.
    const std::map<Index, std::uint64_t>& starved() const { return starved_; }
    /// The number of cycles in which each drive used up the budget of acts, by its place.
    const std::map<Index, std::uint64_t>& spun() const { return spun_; }

private:
    struct Switch {
        std::int64_t time_ms = 0;
        std::pair<Index, Index> drives{nowhere, nowhere};
    };
    void countWarning(const TraceRecord& record);
    void noteWinner(const TraceRecord& record);
    void beginCycle(std::int64_t now_ms);

    std::shared_ptr<const Program> program_;
    std::vector<PlaceCounts> counts_; ///< indexed by place
    std::uint64_t cycles_ = 0;
    std::map<std::pair<Index, Index>, Alternation> alternations_;
    std::map<Index, std::uint64_t> starved_;
    std::map<Index, std::uint64_t> spun_;
    std::vector<Switch> switches_; ///< those within the last alternation_within_ms
    Index winner_ = nowhere;       ///< place of the drive that started last
    Index acting_ = nowhere;       ///< place of the act that was run last in this cycle
    std::int64_t now_ms_ = 0;      ///< time at which this cycle began
};

} // namespace usar::posh
