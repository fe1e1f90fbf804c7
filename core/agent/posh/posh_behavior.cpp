#include "core/agent/posh/posh_behavior.h"

#include <cmath>

#include <QScopeGuard>

#include "core/posh/language/plan_reader.h"

namespace usar::agent {

void PoshBehavior::Reporter::takeProgram(const std::shared_ptr<const posh::Program>& program) {
    program_ = program;
    reported_.clear();
    encoder_.takeProgram(program);
    debugger_.takeProgram(program);
    if (next_)
        next_->takeProgram(program);
}

void PoshBehavior::Reporter::take(const posh::TraceRecord& record, std::string_view text) {
    if (record.event == posh::TraceEvent::Error || record.event == posh::TraceEvent::Warning)
        report(record, text);
    encoder_.take(record, text);
    debugger_.take(record, text);
    if (next_)
        next_->take(record, text);
}

void PoshBehavior::Reporter::watch(posh::TraceObserver* observer) {
    next_ = observer;
    if (next_)
        next_->takeProgram(program_);
}

void PoshBehavior::Reporter::report(const posh::TraceRecord& record, std::string_view text) {
    const bool is_error = record.event == posh::TraceEvent::Error;
    const bool of_act = program_->places[record.place].kind == posh::PlaceKind::Act;
    const bool spins_or_starves = !is_error && (record.warning() == posh::WarningCode::Budget ||
                                                record.warning() == posh::WarningCode::StarvingDrive);
    needs_safety = needs_safety || (is_error && of_act) || spins_or_starves;
    if (!reported_.emplace(record.place, text).second)
        return;
    const Severity severity = is_error || spins_or_starves ? Severity::Error : Severity::Warning;
    events.push_back({severity, "Plan: " + posh::namePathOf(*program_, record.place) + ": " + std::string(text) + "."});
}

Result<std::unique_ptr<PoshBehavior>> PoshBehavior::make(PoshParts parts) {
    PlanForRobot plan = bindPlan(parts.plan_text, parts.registry.descriptions());
    if (!plan.program)
        return tl::unexpected(planRefusal(parts.plan_name, plan.findings));
    parts.options.on_goal = posh::OnGoal::Stop;
    return std::unique_ptr<PoshBehavior>(new PoshBehavior(std::move(parts), std::move(plan.program)));
}

PoshBehavior::PoshBehavior(PoshParts parts, std::shared_ptr<const posh::Program> program)
    : parts_(std::move(parts))
    , host_(parts_.registry, *parts_.body)
    , debugger_(host_)
    , reporter_(parts_.plan_text, debugger_.observer())
    , engine_(debugger_.host(), std::move(program), parts_.options) {
    parts_.body->engine_ = &engine_;
    engine_.watch(&reporter_);
}

PoshBehavior::~PoshBehavior() {
    engine_.stop();
    engine_.watch(nullptr);
    parts_.body->engine_ = nullptr;
}

void PoshBehavior::tick(const Tick& tick, CommandPort& port) {
    if (finished_)
        return;
    if (!began_) {
        began_ = tick.now;
        remark(port);
    }
    PoshBody& body = *parts_.body;
    body.port_ = &port;
    body.modules_ = &tick.robot;
    body.now_ = tick.now;
    body.drive_.reset(); // from an act that was called outside a tick
    const auto close = qScopeGuard([&body] {
        body.port_ = nullptr;
        body.modules_ = nullptr;
    });
    body.begin(tick);
    std::optional<PlanHalted> halt;
    if (!paused_ && !landing_ && !debugger_.halted())
        halt = runCycle(tick, port);
    body.end(tick);
    port.publish(PlanTrace{reporter_.takeTrace()});
    publishStatus(tick, port);
    if (body.drive_)
        last_drive_ = {*body.drive_, {body.drive_source_, {}}};
    if (!halt)
        return body.sendDrive();
    body.drive_.reset(); // The robot gets `last_drive_` when the plan continues.
    port.send(safeCommand(), "plan halted");
    port.publish(*std::move(halt));
}

std::optional<PlanHalted> PoshBehavior::runCycle(const Tick& tick, CommandPort& port) {
    PoshBody& body = *parts_.body;
    reporter_.needs_safety = false;
    body.cycle_ = engine_.cycleNumber() + 1;
    const posh::Outcome outcome = engine_.cycle(posh::Milliseconds(std::llround(tick.now.count() * 1000.0)));
    body.place_ = 0;
    const bool is_idle = outcome == posh::Outcome::Idle;
    const bool undriven = debugger_.takeActed() && !body.drive_; // otherwise it would keep obeying the act before
    if (reporter_.needs_safety || (is_idle && !idle_) || undriven)
        body.drive(body.safeCommand());
    idle_ = is_idle;
    report(outcome, port);
    std::optional<PlanHalted> halt = debugger_.afterCycle(engine_, tick.now);
    if (finished_)
        debugger_.release();
    return finished_ ? std::nullopt : std::move(halt);
}

void PoshBehavior::report(posh::Outcome outcome, CommandPort& port) {
    for (BehaviorEvent& event : reporter_.events)
        port.publish(std::move(event));
    reporter_.events.clear();
    std::optional<BehaviorFinished> end = parts_.body->ended();
    if (!end && (outcome == posh::Outcome::GoalSatisfied || outcome == posh::Outcome::Won))
        end = parts_.body->finished();
    if (!end)
        return;
    finished_ = true;
    parts_.body->drive(parts_.body->safeCommand());
    port.publish(*std::move(end));
}

void PoshBehavior::publishStatus(const Tick& tick, CommandPort& port) {
    BehaviorStatus status;
    status.time = tick.now;
    status.elapsed = tick.now - *began_;
    status.paused = paused_;
    const posh::Index act = engine_.currentAct();
    const posh::Program& program = *engine_.program();
    if (landing_)
        status.state = "plan stopped";
    else if (act == posh::nowhere)
        status.state = program.title;
    else
        status.state = posh::namePathOf(program, program.acts[act].place);
    parts_.body->describe(status);
    port.publish(std::move(status));
}

void PoshBehavior::order(Order order, CommandPort& port) {
    if (finished_)
        return;
    if (order == Order::LandNow)
        goOn(port);
    if (parts_.body->order(order))
        return;
    if (order == Order::LandNow)
        return land(port);
    paused_ = order == Order::Pause;
    if (!paused_)
        return;
    last_drive_.reset();
    port.send(safeCommand(), "paused");
}

/// The safe command is the only response to the order if the body does not handle it.
void PoshBehavior::land(CommandPort& port) {
    landing_ = true;
    engine_.stop();
    port.send(safeCommand(), "plan stopped");
    port.publish(BehaviorEvent{Severity::Warning, "The plan is stopped; this robot knows no way to land at once."});
}

void PoshBehavior::control(const PlanControl& control, CommandPort& port) {
    std::visit([&](const auto& asked) { obey(asked, port); }, control);
}

void PoshBehavior::remark(CommandPort& port) {
    if (std::string words = clockRemark(posh::readPlan(parts_.plan_text).plan); !words.empty())
        port.publish(BehaviorEvent{Severity::Note, std::move(words)});
}

void PoshBehavior::obey(const ReplacePlan& asked, CommandPort& port) {
    PlanReplaced news = replacePlan(asked.plan);
    if (news.fate != PlanFate::Refused)
        remark(port);
    if (news.fate == PlanFate::Restarted && !debugger_.halted() && !paused_)
        port.send(safeCommand(), "plan replaced"); // the last command of the old plan's act no longer applies
    port.publish(std::move(news));
}

PlanReplaced PoshBehavior::replacePlan(const PlanText& plan) {
    PlanReplaced news{.fate = PlanFate::Refused, .plan_name = plan.name, .cycle = engine_.cycleNumber()};
    if (finished_ || landing_) {
        news.reason = finished_ ? "The behavior has ended." : "The plan was stopped by the order to land.";
        return news;
    }
    PlanForRobot bound = bindPlan(plan.text, parts_.registry.descriptions());
    news.findings = std::move(bound.findings);
    if (!bound.program)
        return news;
    reporter_.setPlanText(plan.text);
    parts_.plan_name = plan.name;
    parts_.plan_text = plan.text;
    if (posh::sameShape(*engine_.program(), *bound.program)) {
        news.fate = PlanFate::Kept;
        engine_.retune(std::move(bound.program));
        return news;
    }
    news.fate = PlanFate::Restarted;
    engine_.replace(std::move(bound.program));
    debugger_.switchDrives(engine_);
    last_drive_.reset();
    idle_ = false;
    return news;
}

void PoshBehavior::obey(const SetBreakpoints& asked, CommandPort& port) {
    for (std::string& refused : debugger_.set(asked))
        port.publish(BehaviorEvent{Severity::Warning, std::move(refused)});
}

void PoshBehavior::obey(PlanStep step, CommandPort& port) {
    if (finished_)
        return;
    if (step == PlanStep::Cycle || (step == PlanStep::Halt && !debugger_.halted()))
        debugger_.haltSoon(step == PlanStep::Cycle);
    if (step != PlanStep::Halt)
        goOn(port);
}

void PoshBehavior::goOn(CommandPort& port) {
    if (!debugger_.halted())
        return;
    debugger_.release();
    if (last_drive_)
        port.send(last_drive_->command, last_drive_->cause.source);
    port.publish(PlanResumed{});
}

} // namespace usar::agent
