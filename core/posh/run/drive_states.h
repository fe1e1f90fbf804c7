// The run-time state of all drives: whether they are in progress, when they started, and which forms are open.
#pragma once

#include <vector>

#include "core/posh/run/tracer.h"

namespace usar::posh {

/// The state of one drive.
struct DriveState {
    bool in_progress = false;
    bool ever_started = false;
    bool switched_off = false;  ///< the user has switched it off, so it is never ready
    Milliseconds last_start{0}; ///< host time; meaningful only if ever_started
    std::uint64_t last_start_cycle = 0;
    std::uint64_t last_barren_cycle = 0; ///< last cycle that it won and in which no act ran at all
    int barren_cycles = 0;               ///< number of such cycles in a row
    std::vector<Index> stack;            ///< open forms, outermost first; never outgrows its reserved capacity
};

/// Starts and ends activations of drives. Remembers for each level which drive ended last.
class DriveStates {
public:
    /// The tracer must outlive this object.
    explicit DriveStates(const Tracer& tracer) : tracer_(tracer) {}

    /// Resets everything and reserves all memory that a run needs.
    void load(const Program& program);
    /// Switches to a program of the same shape and keeps all states.
    void retune(const Program& program) { program_ = &program; }
    DriveState& operator[](Index drive) { return states_[drive]; }
    const DriveState& operator[](Index drive) const { return states_[drive]; }
    /// The drive of the level whose activation ended last; `nowhere` if none has ended yet.
    Index lastEnded(Index level) const { return last_ended_[level]; }

    void start(Index drive);
    /// Ends an activation; `how` is DriveSucceeded or DriveFailed. The stack must be empty.
    void end(Index drive, TraceEvent how);
    /// Cuts the stack back to the innermost adopt; without one the activation ends. `winner` is the drive that takes
    /// over, or `nowhere`.
    void interrupt(Index drive, Index winner);
    /// Closes the innermost form. The stack must not be empty.
    void pop(DriveState& state);
    /// Ends all activations without tracing anything.
    void clear();

private:
    const Tracer& tracer_;
    const Program* program_ = nullptr;
    std::vector<DriveState> states_;
    std::vector<Index> last_ended_; ///< indexed by level
};

} // namespace usar::posh
