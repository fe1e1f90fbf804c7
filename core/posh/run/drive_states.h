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
    /// Meaningful only if ever_started, too.
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

    /// Resets everything and reserves all memory that a run of the tracer's program needs.
    void load() {
        const Program& program = *tracer_.program();
        states_.assign(program.drives.size(), {});
        for (std::size_t i = 0; i < states_.size(); ++i)
            states_[i].stack.reserve(program.drives[i].depth);
        last_ended_.assign(program.levels.size(), nowhere);
    }
    /// The state of a drive, by its index in Program::drives; valid until the next `load`.
    DriveState& operator[](Index drive) { return states_[drive]; }
    /// The drive of the level whose activation ended last; `nowhere` if none has ended yet.
    Index lastEnded(Index level) const { return last_ended_[level]; }

    /// Begins an activation at the tracer's time and cycle, and traces it.
    void start(Index drive) {
        DriveState& state = states_[drive];
        state.in_progress = true;
        state.ever_started = true;
        state.last_start = tracer_.now();
        state.last_start_cycle = tracer_.cycle();
        tracer_.note(TraceEvent::DriveStarted, driveAt(drive).place);
    }
    /// Ends an activation; `how` is DriveSucceeded or DriveFailed. The stack must be empty.
    void end(Index drive, TraceEvent how) {
        states_[drive].in_progress = false;
        last_ended_[driveAt(drive).level] = drive;
        tracer_.note(how, driveAt(drive).place);
    }
    /// Cuts the stack back to the innermost adopt; without one the activation ends. `winner` is the drive that takes
    /// over, or `nowhere`.
    void interrupt(Index drive, Index winner) {
        DriveState& state = states_[drive];
        while (!state.stack.empty() && tracer_.program()->forms[state.stack.back()].kind != PlaceKind::Adopt)
            pop(state);
        state.in_progress = !state.stack.empty();
        const Index winner_place = winner == nowhere ? nowhere : driveAt(winner).place;
        tracer_.note(TraceEvent::DriveInterrupted, driveAt(drive).place, winner_place, 0,
                     state.in_progress ? trace_adopt_kept : std::uint8_t{0});
    }
    /// Closes the innermost form. The stack must not be empty.
    void pop(DriveState& state) {
        tracer_.note(TraceEvent::Pop, tracer_.program()->forms[state.stack.back()].place);
        state.stack.pop_back();
    }
    /// Ends all activations without tracing anything.
    void clear() {
        for (DriveState& state : states_) {
            state.in_progress = false;
            state.stack.clear();
        }
    }

private:
    /// The compiled drive with this index.
    const ProgramDrive& driveAt(Index index) const { return tracer_.program()->drives[index]; }

    /// Source of the program, the time and the number of the cycle.
    const Tracer& tracer_;
    std::vector<DriveState> states_;
    std::vector<Index> last_ended_; ///< indexed by level
};

} // namespace usar::posh
