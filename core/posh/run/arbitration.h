// Chooses the drive that runs in an epoch.
#pragma once

#include "core/posh/run/drive_states.h"
#include "core/posh/run/sense_memo.h"

namespace usar::posh {

/// Searches the levels in order of priority. Within a level a ready drive that is in progress keeps running; the others
/// take turns, starting after the one that ended last. Runs in the engine's thread, and calls the host to evaluate
/// triggers.
class Arbitration {
public:
    /// All three must outlive this object.
    Arbitration(const Tracer& tracer, SenseMemo& senses, DriveStates& drives)
        : tracer_(tracer)
        , senses_(senses)
        , drives_(drives) {}

    void load(const Program& program) { program_ = &program; }
    /// Returns the winning drive as an index in Program::drives, or `nowhere` if no drive is ready. `active` is the
    /// drive that won last, or `nowhere`.
    Index choose(Index active);

private:
    /// Returns the winner within one level, or `nowhere`.
    Index chooseIn(Index level, Index active);
    bool ready(Index drive);
    /// Returns whether the drive's frequency forbids a start now.
    bool heldBack(Index drive);

    const Tracer& tracer_;
    SenseMemo& senses_;
    DriveStates& drives_;
    const Program* program_ = nullptr;
};

} // namespace usar::posh
