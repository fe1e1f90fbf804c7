// Where a person wants a run to stop: on any element, on what happens to it, and on conditions.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/posh/trace_event.h"

namespace usar::posh {

enum class BreakOn {
    Before,        ///< a drive starts, an element is selected, a form is entered, an act begins, a sense is asked
    After,         ///< a drive's activation, a form or an act is over
    Result,        ///< an act answers with `result`
    VerdictChange, ///< a sense holds that did not, or the reverse
    Interruption,  ///< a drive or an act is interrupted
    Written,       ///< an act writes another value onto the blackboard, under `key`
};

/// Kept with a plan: paths are repaired by the names when the plan has changed.
struct Breakpoint {
    std::string path;  ///< "/P:0/DC:0/DE:1": see pathOf
    std::string names; ///< "robot ▸ work": see namePathOf
    BreakOn on = BreakOn::Before;
    ActResult result = ActResult::Failed; ///< for BreakOn::Result
    std::string key{};                    ///< for BreakOn::Written; the place is that of the whole plan
    std::string condition;                ///< senses as in a trigger: "(distance 0.3 <) (bumped)"; empty: always.
                                          ///< Keys of the blackboard can be asked for as senses can: "(lane 3 >=)"
    std::uint64_t skip = 0;               ///< so many hits are passed over first
    bool once = false;                    ///< is switched off by its hit
    bool enabled = true;
    bool operator==(const Breakpoint&) const = default;
};

struct BreakHit {
    std::size_t breakpoint = 0; ///< its number
    TraceRecord record;
    std::string text{}; ///< beside the record
    bool operator==(const BreakHit&) const = default;
};

/// Watches a run and collects hits; whoever runs the cycles looks for them after each and stops. Conditions are of the
/// newest answers that the run itself has got: nothing is asked for them, and a sense that was never asked does not
/// hold.
class Breakpoints final : public TraceObserver {
public:
    /// The number of the breakpoint. A condition that is no list of senses is an error; a place that the plan has not
    /// is none, as another plan may have it.
    Result<std::size_t> add(Breakpoint breakpoint);
    /// Whether it is a list of senses, or empty.
    static Result<void> checkCondition(const std::string& text);
    void remove(std::size_t number);
    /// By number; removed ones are missing.
    const std::map<std::size_t, Breakpoint>& all() const { return breakpoints_; }
    void enable(std::size_t number, bool enabled) { breakpoints_.at(number).enabled = enabled; }
    /// Where it stands in the plan that runs; nowhere if that has no such place.
    Index placeOf(std::size_t number) const { return watches_.at(number).place; }

    std::vector<BreakHit> takeHits();

    void takeProgram(const std::shared_ptr<const Program>& program) override;
    void take(const TraceRecord& record, std::string_view text) override;

private:
    struct Watch {
        Index place = nowhere;
        std::shared_ptr<const Program> condition; ///< its one drive's trigger; none: always
        std::uint64_t hits = 0;
        std::optional<bool> verdict;
    };
    static Result<std::shared_ptr<const Program>> readCondition(const std::string& text);
    Index find(const Breakpoint& breakpoint) const;
    bool happens(const Breakpoint& breakpoint, Watch& watch, const TraceRecord& record, std::string_view text) const;
    bool conditionHolds(const Watch& watch) const;
    void remember(std::string_view call, Value answer);

    std::shared_ptr<const Program> program_;
    std::map<std::size_t, Breakpoint> breakpoints_;
    std::map<std::size_t, Watch> watches_;
    std::map<std::string, Value, std::less<>> answers_; ///< newest, by call
    std::vector<BreakHit> hits_;
    std::size_t next_number_ = 0;
};

} // namespace usar::posh
