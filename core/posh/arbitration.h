// Which drive wins: the first that is ready, by levels; in a level the one in progress, then turn by turn.
#pragma once

#include "core/posh/drive_states.h"
#include "core/posh/sense_memo.h"

namespace usar::posh {

class Arbitration {
public:
    Arbitration(const Tracer& tracer, SenseMemo& senses, DriveStates& drives)
        : tracer_(tracer)
        , senses_(senses)
        , drives_(drives) {}

    void load(const Program& program) { program_ = &program; }
    /// Nowhere when none is ready. `active` may be nowhere.
    Index choose(Index active);

private:
    Index chooseIn(Index level, Index active);
    bool ready(Index drive);
    bool heldBack(Index drive);

    const Tracer& tracer_;
    SenseMemo& senses_;
    DriveStates& drives_;
    const Program* program_ = nullptr;
};

} // namespace usar::posh
