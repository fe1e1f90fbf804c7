#include "core/posh/run/arbitration.h"

namespace usar::posh {

Index Arbitration::choose(Index active) {
    for (Index level = 0; level < program_->levels.size(); ++level) {
        const Range drives = program_->levels[level].drives;
        if (drives.end - drives.first == 1) {
            if (ready(drives.first))
                return drives.first;
        } else if (const Index winner = chooseIn(level, active); winner != nowhere) {
            return winner;
        }
    }
    return nowhere;
}

Index Arbitration::chooseIn(Index level, Index active) {
    const Range drives = program_->levels[level].drives;
    const bool has_active = drives.contains(active) && drives_[active].in_progress;
    if (has_active && ready(active))
        return active;
    const Index count = drives.end - drives.first;
    const Index last = drives_.lastEnded(level);
    const Index begin = last == nowhere ? 0 : last - drives.first + 1;
    for (Index turn = 0; turn < count; ++turn) {
        const Index drive = drives.first + (begin + turn) % count;
        if (!(has_active && drive == active) && ready(drive))
            return drive;
    }
    return nowhere;
}

bool Arbitration::ready(Index drive) {
    const DriveState& state = drives_[drive];
    if (state.switched_off) {
        tracer_.note(TraceEvent::DriveSkipped, program_->drives[drive].place, payloadOf(0.0),
                     static_cast<std::uint8_t>(SkipReason::SwitchedOff));
        return false;
    }
    if (!state.in_progress && state.ever_started && heldBack(drive))
        return false;
    return senses_.allHold(program_->drives[drive].trigger);
}

bool Arbitration::heldBack(Index drive) {
    const ProgramDrive& here = program_->drives[drive];
    const DriveState& state = drives_[drive];
    double left = here.interval_ms - static_cast<double>((tracer_.now() - state.last_start).count());
    if (here.interval_cycles > 0.0)
        left = here.interval_cycles - static_cast<double>(tracer_.cycle() - state.last_start_cycle);
    if (left <= 0.0)
        return false;
    tracer_.note(TraceEvent::DriveSkipped, here.place, payloadOf(left),
                 static_cast<std::uint8_t>(SkipReason::Frequency));
    return true;
}

} // namespace usar::posh
