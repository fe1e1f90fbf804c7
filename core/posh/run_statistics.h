// What became of each place of a plan, counted over one run or many.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "core/posh/trace_event.h"

namespace usar::posh {

/// Only what fits the kind of a place is counted; times are of the host's clock.
struct PlaceCounts {
    std::uint64_t asked = 0; ///< a sense, each place of it; cached answers too
    std::uint64_t held = 0;
    std::uint64_t started = 0; ///< a drive, an element (selected), a form (entered), an act (init)
    std::uint64_t succeeded = 0;
    std::uint64_t failed = 0;
    std::uint64_t interrupted = 0;
    std::uint64_t skipped = 0; ///< by frequency or retries
    std::uint64_t runs = 0;    ///< of an act: cycles that it ran in
    /// That passed from cycles in which it was run last to the cycles after them; of all above an act the sum of what
    /// is below.
    std::int64_t active_ms = 0;
    std::uint64_t spent_ns = 0; ///< of an act in its runs, where somebody measured
    std::uint64_t longest_ns = 0;
    std::uint64_t last_cycle = 0; ///< that counted anything here
    bool operator==(const PlaceCounts&) const = default;
};

/// Two drives that took turns: `most` switches between them within the watched time.
struct Alternation {
    int most = 0;
    std::uint64_t cycle = 0; ///< of the last switch of those
    bool operator==(const Alternation&) const = default;
};

/// Counts while it watches. Runs of one plan add up; another plan begins anew. Records of places that the plan has not,
/// as a damaged file may hold, are passed over.
class RunStatistics final : public TraceObserver {
public:
    /// Switches that lie further apart are no alternation.
    static constexpr std::int64_t alternation_within_ms = 10'000;

    void takeProgram(const std::shared_ptr<const Program>& program) override;
    /// It goes on with a program of the same shape (see sameShape), whatever its names.
    void retune(const std::shared_ptr<const Program>& program) { program_ = program; }
    void take(const TraceRecord& record, std::string_view text) override;
    /// Adds what was counted elsewhere; false, and nothing added, where that was of a plan with other places.
    bool add(const RunStatistics& other);

    const std::shared_ptr<const Program>& program() const { return program_; }
    std::uint64_t cycles() const { return cycles_; }
    const PlaceCounts& at(Index place) const { return counts_[place]; }
    /// By the places of two drives, the smaller first.
    const std::map<std::pair<Index, Index>, Alternation>& alternations() const { return alternations_; }
    /// Places of the drives that were reported as starving.
    const std::map<Index, std::uint64_t>& starved() const { return starved_; }
    /// Cycles that ended because the budget of acts was used up, by the drive that used it.
    const std::map<Index, std::uint64_t>& spun() const { return spun_; }

private:
    struct Switch {
        std::int64_t time_ms = 0;
        std::pair<Index, Index> drives{nowhere, nowhere};
    };
    void countDrive(const TraceRecord& record, PlaceCounts& counts);
    void countAct(const TraceRecord& record, PlaceCounts& counts);
    void countWarning(const TraceRecord& record);
    void noteWinner(const TraceRecord& record);
    void beginCycle(std::int64_t now_ms);

    std::shared_ptr<const Program> program_;
    std::vector<PlaceCounts> counts_; ///< by place
    std::uint64_t cycles_ = 0;
    std::map<std::pair<Index, Index>, Alternation> alternations_;
    std::map<Index, std::uint64_t> starved_;
    std::map<Index, std::uint64_t> spun_;
    std::vector<Switch> switches_; ///< of the last moments
    Index winner_ = nowhere;       ///< place of the drive that started last
    Index acting_ = nowhere;       ///< place of the act that was run last in this cycle
    std::int64_t now_ms_ = 0;      ///< when this cycle began
};

} // namespace usar::posh
