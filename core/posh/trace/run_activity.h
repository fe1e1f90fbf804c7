// The present and past activity of each place of a running plan, computed from its trace. Live views and the
// explanation why a part does not run use it.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/posh/trace/run_statistics.h"

namespace usar::posh {

/// The newest answer of a sense at one place of the plan. Times are in milliseconds of the engine's time.
struct PlaceAnswer {
    Value value;
    bool holds = false;        ///< the verdict, after the comparison with the operand
    std::int64_t since_ms = 0; ///< time since which the verdict has been the same
    std::int64_t asked_ms = 0; ///< time of the newest answer
    bool operator==(const PlaceAnswer&) const = default;
};

/// The activity of one place. The counts are those of RunStatistics.
struct PlaceActivity {
    bool running = false;                       ///< was active in the newest cycle, itself or through a part below it
    std::optional<std::int64_t> last_active_ms; ///< nullopt if it was never active
    std::uint64_t started = 0;
    std::uint64_t succeeded = 0;
    std::uint64_t failed = 0;  ///< including interruptions
    std::uint64_t skipped = 0; ///< how often its frequency, its retries or the user held it back
    std::string hold_back; ///< what holds it back in the newest cycle: "its frequency: 1.2 s left"; empty if nothing
    std::optional<PlaceAnswer> answer; ///< for a sense; nullopt before the first answer
    bool operator==(const PlaceActivity&) const = default;
};

/// The history of one key of the plan's blackboard. Values are spelled as traces print them.
struct BoardEntry {
    struct Written {
        std::string value;
        std::int64_t time_ms = 0; ///< in the engine's time
        Index writer = 0;         ///< place of the act that wrote it
        bool operator==(const Written&) const = default;
    };
    std::string key;
    std::vector<Written> values; ///< at most `most_values`, the newest last
    std::uint64_t writes = 0;    ///< number of times that the value changed

    static constexpr std::size_t most_values = 8;
};

/// Must receive every record of the run in order. The cost of a record is at most proportional to the depth of its
/// place.
class RunActivity {
public:
    /// Resets the activity for a program that begins to run; nullptr means that none runs. Keeps the blackboard if one
    /// program replaces another.
    void start(std::shared_ptr<const Program> program);
    /// Continues with a program of the same shape (see sameShape).
    void retune(const std::shared_ptr<const Program>& program) {
        program_ = program;
        statistics_.retune(program);
    }
    /// Takes the next record with its text; records of places that the program does not have are ignored.
    void take(const TraceRecord& record, std::string_view text);

    /// The running program; nullptr before the first start.
    const std::shared_ptr<const Program>& program() const { return program_; }
    /// By index of the place in the program.
    const std::vector<PlaceActivity>& places() const { return places_; }
    /// The statistics of the run of this program.
    const RunStatistics& statistics() const { return statistics_; }
    /// The engine's time at the beginning of the newest cycle.
    std::int64_t now_ms() const { return now_ms_; }
    /// The blackboard, sorted by key. Like the blackboard itself it survives the replacement of the program.
    const std::vector<BoardEntry>& board() const { return board_; }

private:
    /// Clears what holds for one cycle only.
    void beginCycle(std::int64_t now_ms);
    /// Keeps the time since which the verdict has been the same.
    void answer(PlaceActivity& place, const TraceRecord& record, std::string_view text) const;
    /// Notes for this cycle why a place does not run.
    void holdBack(Index place, std::string why);
    /// Marks a place and all places above it as running.
    void activate(Index place);
    /// Enters a change of the blackboard; a text that is none is ignored.
    void write(const TraceRecord& record, std::string_view text);

    std::shared_ptr<const Program> program_;
    RunStatistics statistics_;
    std::vector<PlaceActivity> places_;
    std::vector<Index> running_; ///< places marked as running in this cycle
    std::vector<Index> held_;    ///< places held back in this cycle
    std::vector<BoardEntry> board_;
    std::int64_t now_ms_ = 0;
};

} // namespace usar::posh
