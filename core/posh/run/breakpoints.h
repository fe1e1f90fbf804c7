// Breakpoints for a running plan: they stop it at a place of the plan, at an event there, and under a condition.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/posh/run/trace_event.h"

namespace usar::posh {

/// The event at the breakpoint's place that triggers it.
enum class BreakOn {
    Before,        ///< a drive starts, an element is selected, a form is entered, an act begins, a sense is evaluated
    After,         ///< a drive's activation, a form or an act has ended
    Result,        ///< an act returns `result`
    VerdictChange, ///< a sense starts or stops holding
    Interruption,  ///< a drive or an act is interrupted
    Written,       ///< an act changes the value of `key` on the blackboard
};

/// One breakpoint, stored along with a plan. If the plan has changed, the place is found again by its names and the
/// path is updated.
struct Breakpoint {
    std::string path;  ///< "/P:0/DC:0/DE:1", as pathOf returns it
    std::string names; ///< "robot ▸ work", as namePathOf returns it
    BreakOn on = BreakOn::Before;
    ActResult result = ActResult::Failed; ///< used by BreakOn::Result only
    std::string key{};                    ///< used by BreakOn::Written only; the place is then that of the whole plan
    std::string condition; ///< senses as in a trigger, "(distance 0.3 <) (bumped)"; empty means always. Blackboard keys
                           ///< can be tested like senses: "(lane 3 >=)"
    std::uint64_t skip = 0; ///< number of hits to ignore first
    bool once = false;      ///< the first hit disables the breakpoint
    bool enabled = true;
    bool operator==(const Breakpoint&) const = default;
};

/// One hit of a breakpoint, with the event that caused it.
struct BreakHit {
    std::size_t breakpoint = 0; ///< the number that Breakpoints::add returned
    TraceRecord record;
    std::string text{}; ///< text that came with the record; empty if none
    bool operator==(const BreakHit&) const = default;
};

/// Watches a run in the engine's thread and collects hits. It cannot stop the engine itself: the caller of
/// Engine::cycle checks takeHits after each cycle and stops running cycles. Conditions use the newest answers that the
/// run itself received: no sense is evaluated for their sake, and a sense that was never evaluated does not hold.
class Breakpoints final : public TraceObserver {
public:
    /// Adds a breakpoint and returns its number. Fails if the condition is not a list of senses. A place that the
    /// current plan does not have is accepted, because a later plan may have it.
    Result<std::size_t> add(Breakpoint breakpoint);
    /// Succeeds for a list of senses and for an empty text.
    static Result<void> checkCondition(const std::string& text);
    /// Does nothing if there is no breakpoint with this number. Numbers are never reused.
    void remove(std::size_t number);
    /// The existing breakpoints by number.
    const std::map<std::size_t, Breakpoint>& all() const { return breakpoints_; }
    /// The breakpoint must exist.
    void enable(std::size_t number, bool enabled) { breakpoints_.at(number).enabled = enabled; }
    /// Returns the place in the running plan, or `nowhere` if that plan has no such place. The breakpoint must exist.
    Index placeOf(std::size_t number) const { return watches_.at(number).place; }

    /// Returns the hits since the last call, oldest first.
    std::vector<BreakHit> takeHits();

    void takeProgram(const std::shared_ptr<const Program>& program) override;
    void take(const TraceRecord& record, std::string_view text) override;

private:
    struct Watch {
        Index place = nowhere;
        /// A program whose only drive has the condition as its trigger; nullptr if there is no condition.
        std::shared_ptr<const Program> condition;
        std::uint64_t hits = 0;      ///< including the skipped ones
        std::optional<bool> verdict; ///< newest verdict of the sense; nullopt before the first
    };
    static Result<std::shared_ptr<const Program>> readCondition(const std::string& text);
    Index find(const Breakpoint& breakpoint) const;
    bool happens(const Breakpoint& breakpoint, Watch& watch, const TraceRecord& record, std::string_view text) const;
    bool conditionHolds(const Watch& watch) const;
    void remember(std::string_view call, Value answer);

    std::shared_ptr<const Program> program_;
    std::map<std::size_t, Breakpoint> breakpoints_;
    std::map<std::size_t, Watch> watches_;
    std::map<std::string, Value, std::less<>> answers_; ///< newest answers by call text, and blackboard values by key
    std::vector<BreakHit> hits_;
    std::size_t next_number_ = 0;
};

} // namespace usar::posh
