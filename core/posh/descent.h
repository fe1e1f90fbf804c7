// One step of a drive: from where it stands down to an act, and what success and failure do on the way up.
#pragma once

#include <optional>
#include <vector>

#include "core/posh/current_act.h"
#include "core/posh/drive_states.h"
#include "core/posh/engagements.h"
#include "core/posh/sense_memo.h"

namespace usar::posh {

class Descent {
public:
    struct Parts {
        const Tracer& tracer;
        SenseMemo& senses;
        DriveStates& drives;
        Engagements& engagements;
        CurrentAct& act;
    };
    explicit Descent(const Parts& parts) : parts_(parts) {}

    void load(const Program& program);
    /// Keeps what it knows; the program has the same shape.
    void retune(const Program& program) { program_ = &program; }
    /// What the act answered that the step ran; nothing if it ran none. The drive must be in progress.
    std::optional<ActResult> step(Index drive);

private:
    enum class Next { GoOn, Over };
    struct Frame {
        Milliseconds pushed{0}; ///< of a pattern
        Index next_step = 0;    ///< of a pattern, in `steps`
    };

    Next checkFrames();
    bool goalHolds(Index form);
    bool timeIsUp(Index form);
    Next reachGoal(std::size_t depth);
    Next timeOut(std::size_t depth);
    void leave(std::size_t depth);

    Next advance();
    Next advancePattern(Index form);
    Next advanceCompetence(Index form);
    Index select(Index form);
    bool continues(const ProgramElement& element) const;
    Next enter(const Target& target);
    Next enterForm(Index form);
    Next runAct(Index act);

    Next succeed();
    Next fail();
    void push(Index form);
    PlaceKind top() const;

    const Parts parts_;
    const Program* program_ = nullptr;
    std::vector<Frame> frames_; ///< by form
    Index drive_ = nowhere;     ///< that is stepped
    DriveState* state_ = nullptr;
    std::optional<ActResult> result_;
};

} // namespace usar::posh
