// One step of a drive: from its innermost open form down to an act, and back up after success or failure.
#pragma once

#include <optional>
#include <vector>

#include "core/posh/run/current_act.h"
#include "core/posh/run/drive_states.h"
#include "core/posh/run/engagements.h"
#include "core/posh/run/sense_memo.h"

namespace usar::posh {

/// Executes the forms of a drive on the drive's own stack, without recursion. A step first checks the goals and time
/// limits of the open forms, then continues in the innermost one until an act has run or the step is over.
class Descent {
public:
    /// All of these must outlive the Descent.
    struct Parts {
        const Tracer& tracer;
        SenseMemo& senses;
        DriveStates& drives;
        Engagements& engagements;
        CurrentAct& act;
    };
    explicit Descent(const Parts& parts) : parts_(parts) {}

    void load() { frames_.assign(program().forms.size(), {}); }
    /// Runs one step of a drive, which must be in progress. Returns the result of the act that it ran, or nullopt if it
    /// ran none.
    std::optional<ActResult> step(Index drive);

private:
    enum class Next { GoOn, Over }; ///< whether the step continues
    struct Frame {
        Milliseconds pushed{0}; ///< time at which a pattern was entered
        Index next_step = 0;    ///< a pattern's next step, as an index in Program::steps
    };

    /// Checks the goal and the time limit of the open form at this depth. Returns nullopt if the form goes on.
    std::optional<Next> check(std::size_t depth);
    bool timeIsUp(Index form);
    /// Ends the form at this depth and all forms inside it; `why` is Goal or Timeout.
    Next endAt(std::size_t depth, TraceEvent why);

    Next advance();
    Next advancePattern(Index form);
    Next advanceCompetence(Index form);
    /// Returns the first ready element of a competence, or `nowhere`.
    Index select(Index form);
    bool continues(const ProgramElement& element) const;
    Next enter(const Target& target);
    Next enterForm(Index form);
    Next runAct(Index act);

    Next succeed();
    Next fail();
    const Program& program() const { return *parts_.tracer.program(); }
    const ProgramForm& formAt(Index index) const { return program().forms[index]; }
    PlaceKind top() const { return formAt(state_->stack.back()).kind; }

    const Parts parts_;
    std::vector<Frame> frames_; ///< indexed by form
    Index drive_ = nowhere;     ///< the drive of the current step
    DriveState* state_ = nullptr;
    std::optional<ActResult> result_;
};

} // namespace usar::posh
