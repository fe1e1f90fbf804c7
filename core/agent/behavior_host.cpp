#include "core/agent/behavior_host.h"

#include <algorithm>
#include <exception>

namespace usar::agent {

BehaviorHost::BehaviorHost(std::unique_ptr<Behavior> behavior, std::string behavior_id)
    : behavior_(std::move(behavior))
    , behavior_id_(std::move(behavior_id)) {}

BehaviorHost::~BehaviorHost() = default;

template <class Call>
void BehaviorHost::guarded(Call&& call) {
    if (finished_)
        return;
    try {
        call();
    } catch (const std::exception& thrown) {
        stopAfterThrow(thrown.what());
    } catch (...) {
        stopAfterThrow("something that is no std::exception");
    }
}

void BehaviorHost::stopAfterThrow(const std::string& what) {
    finished_ = true;
    port_.takeCommands(); // what it wanted before it failed is not to be trusted
    CausedCommand safe = safeCommand("stopped after a fault");
    port_.send(std::move(safe.command), "stopped after a fault");
    port_.publish(BehaviorFinished{false, "The behavior " + behavior_id_ + " failed: " + what + "."});
}

template <class Module>
void BehaviorHost::ask(Module& module, const std::string& subject) {
    if (auto question = module.next(modules_.state.now()))
        port_.send(*std::move(question), subject + " module");
    for (const auto& [type, name, no_such_thing] : module.takeFailures()) {
        const std::string what = name.empty() ? type : type + " " + name;
        port_.publish(BehaviorEvent{.severity = Severity::Warning,
                                    .text = no_such_thing
                                                ? "The server knows no " + what + ": it has no " + subject + "."
                                                : "No answer about the " + subject + " of " + what +
                                                      " after three tries. Is it mounted on this robot?"});
    }
}

void BehaviorHost::askQuestions() {
    ask(modules_.geometry, "geometry");
    ask(modules_.configuration, "configuration");
}

BehaviorHost::Output BehaviorHost::receive(const protocol::InfoLine& line) {
    last_line_ = line.number;
    port_.setTrigger(line.number);
    modules_.take(line);
    guarded([&] { behavior_->onInfo(line, port_); });
    if (std::holds_alternative<protocol::RobotState>(line.message))
        guarded([&] { behavior_->tick({modules_.state.now(), line.number, modules_}, port_); });
    if (!finished_)
        askQuestions();
    return takeOutput();
}

BehaviorHost::Output BehaviorHost::order(Order order) {
    port_.setTrigger(last_line_);
    guarded([&] { behavior_->order(order, port_); });
    return takeOutput();
}

BehaviorHost::Output BehaviorHost::control(const PlanControl& control) {
    port_.setTrigger(last_line_);
    guarded([&] { behavior_->control(control, port_); });
    return takeOutput();
}

void BehaviorHost::setParameters(const ParameterSet& parameters) {
    port_.setTrigger(last_line_);
    guarded([&] { behavior_->setParameters(parameters); });
}

CausedCommand BehaviorHost::safeCommand(const std::string& source) const {
    const Cause cause{source, last_line_};
    try {
        return {behavior_->safeCommand(), cause};
    } catch (...) {
        const auto& state = modules_.state.latest();
        if (state && state->kind == protocol::VehicleKind::Ground)
            return {protocol::SkidDrive{0.0, 0.0}, cause};
        if (state && state->kind == protocol::VehicleKind::Nautic)
            return {protocol::NauticDrive{0.0, 0.0, 0.0}, cause};
        return {protocol::AerialDrive{0.0, 0.0, 0.0, 0.0}, cause};
    }
}

BehaviorHost::Output BehaviorHost::takeOutput() {
    Output output{port_.takeCommands(), port_.takePublished()};
    for (CausedCommand& caused : output.commands)
        caused.cause.source.insert(0, behavior_id_ + ": ");
    for (const Published& value : output.published) {
        finished_ = finished_ || std::holds_alternative<BehaviorFinished>(value);
        if (std::holds_alternative<PlanHalted>(value) || std::holds_alternative<PlanResumed>(value))
            halted_ = std::holds_alternative<PlanHalted>(value);
    }
    halted_ = halted_ && !finished_;
    return output;
}

} // namespace usar::agent
