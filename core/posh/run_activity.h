// What each place of a running plan does and has done, folded from its trace: for live views and "why not?".
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/posh/run_statistics.h"

namespace usar::posh {

/// The newest answer of a sense at one place of the plan. Times are those of the engine.
struct PlaceAnswer {
    Value value;
    bool holds = false;        ///< after the comparison
    std::int64_t since_ms = 0; ///< the verdict has been this one
    std::int64_t asked_ms = 0; ///< last
    bool operator==(const PlaceAnswer&) const = default;
};

struct PlaceActivity {
    bool running = false; ///< on the way from the root to what was done in the newest cycle
    std::optional<std::int64_t> last_active_ms;
    std::uint64_t started = 0; ///< this and the next three as RunStatistics counts them
    std::uint64_t succeeded = 0;
    std::uint64_t failed = 0;  ///< and interrupted
    std::uint64_t skipped = 0; ///< held back by its frequency, its retries or by hand
    std::string hold_back;     ///< why in the newest cycle: "its frequency: 1.2 s left"; empty where nothing does
    std::optional<PlaceAnswer> answer;
    bool operator==(const PlaceActivity&) const = default;
};

/// A key of the plan's blackboard. Values are spelled as traces print them.
struct BoardEntry {
    struct Written {
        std::string value;
        std::int64_t time_ms = 0;
        Index writer = 0; ///< the place of the act
        bool operator==(const Written&) const = default;
    };
    std::string key;
    std::vector<Written> values; ///< the newest last, `most_values` at most
    std::uint64_t writes = 0;    ///< of other values than it had
    bool operator==(const BoardEntry&) const = default;

    static constexpr std::size_t most_values = 8;
};

/// Fed with every record in order; each costs the depth of its place at most.
class RunActivity {
public:
    /// A program begins to run: nothing has happened yet.
    void start(std::shared_ptr<const Program> program);
    /// It goes on with a program of the same shape (see sameShape).
    void retune(const std::shared_ptr<const Program>& program) {
        program_ = program;
        statistics_.retune(program);
    }
    void take(const TraceRecord& record, std::string_view text);

    const std::shared_ptr<const Program>& program() const { return program_; }
    const std::vector<PlaceActivity>& places() const { return places_; }
    /// Of this run, for its report.
    const RunStatistics& statistics() const { return statistics_; }
    std::int64_t now_ms() const { return now_ms_; }
    /// By key; it outlives a program that is replaced, as the blackboard does.
    const std::vector<BoardEntry>& board() const { return board_; }

private:
    void beginCycle(std::int64_t now_ms);
    void answer(PlaceActivity& place, const TraceRecord& record, std::string_view text) const;
    void holdBack(Index place, std::string why);
    void activate(Index place);
    void write(const TraceRecord& record, std::string_view text);

    std::shared_ptr<const Program> program_;
    RunStatistics statistics_;
    std::vector<PlaceActivity> places_;
    std::vector<Index> running_; ///< places marked in this cycle
    std::vector<Index> held_;
    std::vector<BoardEntry> board_;
    std::int64_t now_ms_ = 0;
};

} // namespace usar::posh
