#include "core/posh/run/descent.h"

namespace usar::posh {

std::optional<ActResult> Descent::step(Index drive) {
    drive_ = drive;
    state_ = &parts_.drives[drive];
    result_.reset();
    for (const Index form : state_->stack)
        if (formAt(form).kind == PlaceKind::Competence)
            parts_.engagements.visit(form);
    std::optional<Next> next;
    for (std::size_t depth = 0; depth < state_->stack.size() && !next;
         ++depth) // From the outermost form to the innermost
        next = check(depth);
    while (next.value_or(Next::GoOn) == Next::GoOn)
        next = advance();
    return result_;
}

std::optional<Descent::Next> Descent::check(std::size_t depth) {
    const Index form = state_->stack[depth];
    const Range goal = formAt(form).goal;
    if (!goal.empty() && parts_.senses.allHold(goal))
        return endAt(depth, TraceEvent::Goal);
    return timeIsUp(form) ? std::optional(endAt(depth, TraceEvent::Timeout)) : std::nullopt;
}

bool Descent::timeIsUp(Index form) {
    const ProgramForm& here = formAt(form);
    if (!here.limit_ms)
        return false;
    const Milliseconds begin =
        here.kind == PlaceKind::Competence ? parts_.engagements.begin(form) : frames_[form].pushed;
    return static_cast<double>((parts_.tracer.now() - begin).count()) >= *here.limit_ms;
}

Descent::Next Descent::endAt(std::size_t depth, TraceEvent why) {
    const Index form = state_->stack[depth];
    parts_.tracer.note(why, formAt(form).place);
    parts_.act.end(DoneReason::Interrupted);
    while (state_->stack.size() > depth)
        parts_.drives.pop(*state_);
    parts_.engagements.endWithin({form, formAt(form).below_end});
    return why == TraceEvent::Goal ? succeed() : fail();
}

Descent::Next Descent::advance() {
    if (state_->stack.empty())
        return enter(program().drives[drive_].target);
    const Index form = state_->stack.back();
    switch (formAt(form).kind) {
    case PlaceKind::Pattern:
        return advancePattern(form);
    case PlaceKind::Competence:
        return advanceCompetence(form);
    default:
        return enter(program().steps[formAt(form).items.first].target);
    }
}

Descent::Next Descent::advancePattern(Index form) {
    const ProgramStep& step = program().steps[frames_[form].next_step];
    if (step.test == nowhere)
        return enter(step.target);
    return parts_.senses.holds(step.test) ? succeed() : fail();
}

Descent::Next Descent::advanceCompetence(Index form) {
    const Index chosen = select(form);
    if (chosen == nowhere) {
        parts_.tracer.note(TraceEvent::NoElement, formAt(form).place);
        parts_.engagements.end(form);
        return fail();
    }
    const ProgramElement& element = program().elements[chosen];
    std::uint64_t& starts = parts_.engagements.starts(chosen);
    if (!continues(element))
        ++starts;
    parts_.tracer.note(TraceEvent::ElementSelected, element.place, starts);
    return enter(element.target);
}

Index Descent::select(Index form) {
    const Range elements = formAt(form).items;
    for (Index i = elements.first; i != elements.end; ++i) {
        const ProgramElement& element = program().elements[i];
        const std::uint64_t starts = parts_.engagements.starts(i);
        if (element.retries > 0 && starts >= static_cast<std::uint64_t>(element.retries) && !continues(element)) {
            parts_.tracer.note(TraceEvent::ElementSkipped, element.place, starts);
            continue;
        }
        if (parts_.senses.allHold(element.trigger))
            return i;
    }
    return nowhere;
}

/// Returns whether the current act is below the element. An act that runs for many cycles is one start of its element.
bool Descent::continues(const ProgramElement& element) const {
    const Index act = parts_.act.index();
    if (act == nowhere)
        return false;
    if (element.target.is_act)
        return element.target.index == act;
    const Range below{element.target.index, formAt(element.target.index).below_end};
    return below.contains(program().acts[act].form);
}

Descent::Next Descent::enter(const Target& target) {
    return target.is_act ? runAct(target.index) : enterForm(target.index);
}

Descent::Next Descent::enterForm(Index form) {
    const ProgramForm& here = formAt(form);
    frames_[form] = {parts_.tracer.now(), here.items.first};
    state_->stack.push_back(form);
    parts_.tracer.note(TraceEvent::Push, here.place);
    if (here.kind == PlaceKind::Pattern)
        return Next::GoOn; // Its time begins now, and it has no goal
    if (here.kind == PlaceKind::Competence)
        parts_.engagements.visit(form);
    return check(state_->stack.size() - 1).value_or(Next::GoOn);
}

Descent::Next Descent::runAct(Index act) {
    result_ = parts_.act.run(act);
    if (*result_ == ActResult::Failed)
        fail();
    else if (*result_ != ActResult::Running)
        succeed();
    else
        while (!state_->stack.empty() && top() == PlaceKind::Competence)
            parts_.drives.pop(*state_);
    return Next::Over;
}

/// Moves up after a success: competences succeed with their element, a pattern goes to its next step, and an adopt
/// stays on the stack.
Descent::Next Descent::succeed() {
    while (!state_->stack.empty() && top() != PlaceKind::Adopt) {
        const Index form = state_->stack.back();
        if (top() == PlaceKind::Pattern && ++frames_[form].next_step != formAt(form).items.end)
            return Next::GoOn;
        parts_.drives.pop(*state_);
    }
    if (state_->stack.empty())
        parts_.drives.end(drive_, TraceEvent::DriveSucceeded);
    return Next::Over;
}

/// Moves up after a failure to the innermost adopt, which tries again in the next cycle; without one the drive fails.
Descent::Next Descent::fail() {
    while (!state_->stack.empty() && top() != PlaceKind::Adopt)
        parts_.drives.pop(*state_);
    if (state_->stack.empty())
        parts_.drives.end(drive_, TraceEvent::DriveFailed);
    else
        parts_.tracer.note(TraceEvent::AdoptRetry, formAt(state_->stack.back()).place);
    return Next::Over;
}

} // namespace usar::posh
