// Where each drive is: in progress or not, when it last started, and the forms that are open below it.
#pragma once

#include <vector>

#include "core/posh/tracer.h"

namespace usar::posh {

struct DriveState {
    bool in_progress = false;
    bool ever_started = false;
    bool switched_off = false;
    Milliseconds last_start{0};
    std::uint64_t last_start_cycle = 0;
    std::uint64_t last_barren_cycle = 0; ///< its step ran no act, and no act had run before
    int barren_cycles = 0;               ///< in a row
    std::vector<Index> stack;            ///< forms, outermost first; never outgrows its capacity
};

/// Starts and ends activations. Keeps, for each level, whose turn it was.
class DriveStates {
public:
    explicit DriveStates(const Tracer& tracer) : tracer_(tracer) {}

    void load(const Program& program);
    /// Keeps what it knows; the program has the same shape.
    void retune(const Program& program) { program_ = &program; }
    DriveState& operator[](Index drive) { return states_[drive]; }
    const DriveState& operator[](Index drive) const { return states_[drive]; }
    /// The drive of the level whose activation ended last; nowhere when none has.
    Index lastEnded(Index level) const { return last_ended_[level]; }

    void start(Index drive);
    /// With DriveSucceeded or DriveFailed. The stack is empty by then.
    void end(Index drive, TraceEvent how);
    /// Cuts the stack back to the innermost adopt; without one the activation is over. `winner` may be nowhere.
    void interrupt(Index drive, Index winner);
    void pop(DriveState& state);
    /// All activations, silently.
    void clear();

private:
    const Tracer& tracer_;
    const Program* program_ = nullptr;
    std::vector<DriveState> states_;
    std::vector<Index> last_ended_; ///< by level
};

} // namespace usar::posh
