#include "core/posh/run/drive_states.h"

namespace usar::posh {

void DriveStates::load(const Program& program) {
    program_ = &program;
    states_.assign(program.drives.size(), {});
    for (std::size_t i = 0; i < states_.size(); ++i)
        states_[i].stack.reserve(program.drives[i].depth);
    last_ended_.assign(program.levels.size(), nowhere);
}

void DriveStates::start(Index drive) {
    DriveState& state = states_[drive];
    state.in_progress = true;
    state.ever_started = true;
    state.last_start = tracer_.now();
    state.last_start_cycle = tracer_.cycle();
    tracer_.note(TraceEvent::DriveStarted, program_->drives[drive].place);
}

void DriveStates::end(Index drive, TraceEvent how) {
    const ProgramDrive& here = program_->drives[drive];
    states_[drive].in_progress = false;
    last_ended_[here.level] = drive;
    tracer_.note(how, here.place);
}

void DriveStates::interrupt(Index drive, Index winner) {
    DriveState& state = states_[drive];
    while (!state.stack.empty() && program_->forms[state.stack.back()].kind != PlaceKind::Adopt)
        pop(state);
    state.in_progress = !state.stack.empty();
    const Index winner_place = winner == nowhere ? nowhere : program_->drives[winner].place;
    tracer_.note(TraceEvent::DriveInterrupted, program_->drives[drive].place, winner_place, 0,
                 state.in_progress ? trace_adopt_kept : std::uint8_t{0});
}

void DriveStates::pop(DriveState& state) {
    tracer_.note(TraceEvent::Pop, program_->forms[state.stack.back()].place);
    state.stack.pop_back();
}

void DriveStates::clear() {
    for (DriveState& state : states_) {
        state.in_progress = false;
        state.stack.clear();
    }
}

} // namespace usar::posh
