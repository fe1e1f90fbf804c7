#include "core/agent/behavior_host.h"

#include <algorithm>
#include <exception>

#include "core/base/text.h"
#include "core/protocol/info_message.h"
#include "core/protocol/silence.h"
#include "core/protocol/zero_drives.h"

namespace usar::agent {

namespace {

/// A visitor that returns the sensor's type on the wire; empty for messages that do not come from sensors.
struct SensorType {
    template <protocol::SensorMessage Sensor>
    std::string_view operator()(const Sensor& reading) const {
        return protocol::wireTypeOf(reading);
    }
    std::string_view operator()(const protocol::GenericMessage& message) const { return message.type; }
    std::string_view operator()(const auto&) const { return {}; }
};

/// Says which behavior decided.
void addId(by::Source& source, const std::string& behavior_id) {
    if (auto* const behavior = std::get_if<by::Behavior>(&source))
        behavior->behavior_id = behavior_id;
    else if (auto* const plan = std::get_if<by::Plan>(&source))
        plan->behavior_id = behavior_id;
}

} // namespace

protocol::Command lastResort(protocol::VehicleKind kind) {
    const std::vector<protocol::Command> zeros = protocol::zeroDrives(kind);
    return zeros.empty() ? protocol::no_flight : zeros.front();
}

BehaviorHost::BehaviorHost(std::unique_ptr<Behavior> behavior, std::string behavior_id,
                           std::vector<std::string> sensors_needed)
    : RunningBehavior(std::move(behavior_id))
    , behavior_(std::move(behavior))
    , sensors_missed_(std::move(sensors_needed)) {
    std::erase_if(sensors_missed_, [](const std::string& type) { return !protocol::speaksAlways(type); });
}

template <class Call>
void BehaviorHost::guarded(Call&& call) {
    if (finished_)
        return;
    try {
        call();
    } catch (const std::exception& thrown) {
        broke_ = true;
        fail(std::string("failed: ") + thrown.what() + ".");
    } catch (...) {
        broke_ = true;
        fail("failed: something that is no std::exception.");
    }
}

void BehaviorHost::fail(const std::string& reason, std::vector<std::string> sensors_missing) {
    finished_ = true;
    port_.takeCommands(); // its output before the fault cannot be trusted
    CausedCommand safe = safeCommand({});
    port_.send(std::move(safe.command), "stopped after a fault");
    port_.publish(BehaviorFinished{false, "The behavior " + behavior_id_ + " " + reason, std::move(sensors_missing)});
}

void BehaviorHost::failForSensors() {
    if (sensors_lacking_.empty() || !sensors_missed_.empty())
        return;
    const bool one = sensors_lacking_.size() == 1;
    fail(std::string("needs the sensor") + (one ? " " : "s ") + listOf(sensors_lacking_) +
             (one ? ", and the robot has none that speaks. Mount it, or choose another behavior."
                  : ", and the robot has none of these that speaks. Mount them, or choose another behavior."),
         sensors_lacking_);
}

template <class Module>
void BehaviorHost::ask(Module& module, const std::string& subject) {
    if (auto question = module.next(modules_.state.now()))
        port_.send(*std::move(question), subject + " module");
    for (const auto& [type, name, no_such_thing] : module.takeFailures()) {
        const std::string what = name.empty() ? type : type + " " + name;
        if (std::erase_if(sensors_missed_, [&type = type](const auto& one) { return sameWord(one, type); }) > 0) {
            sensors_lacking_.push_back(type);
            continue;
        }
        port_.publish(BehaviorEvent{.severity = Severity::Warning,
                                    .text = no_such_thing
                                                ? "The server knows no " + what + ": it has no " + subject + "."
                                                : "No answer about the " + subject + " of " + what +
                                                      " after three tries. Is it mounted on this robot?"});
    }
}

void BehaviorHost::noteSensor(const protocol::InfoMessage& message) {
    const std::string_view type = std::visit(SensorType(), static_cast<const protocol::InfoVariant&>(message));
    const auto is_it = [type](const std::string& one) { return sameWord(one, type); };
    if (type.empty())
        return;
    std::erase_if(sensors_missed_, is_it);
    std::erase_if(sensors_lacking_, is_it);
}

/// A sensor that exists but has nothing to report still has a configuration, so this is what the server is asked for.
void BehaviorHost::askForSensors() {
    if (!first_tick_)
        first_tick_ = modules_.state.now();
    if (modules_.state.now() - *first_tick_ < protocol::silence::sensor)
        return;
    std::erase_if(sensors_missed_, [this](const std::string& type) {
        return modules_.configuration.state(type) == modules::QueryState::Ready;
    });
    for (const std::string& type : sensors_missed_)
        if (modules_.configuration.state(type) == modules::QueryState::Unknown)
            modules_.configuration.query(type);
}

RunningBehavior::Output BehaviorHost::receive(const protocol::InfoLine& line) {
    last_line_ = line.number;
    port_.setTrigger(line.number);
    modules_.take(line);
    if (!sensors_missed_.empty() || !sensors_lacking_.empty())
        noteSensor(line.message);
    guarded([&] { behavior_->onInfo(line, port_); });
    if (std::holds_alternative<protocol::RobotState>(line.message))
        guarded([&] { behavior_->tick({modules_.state.now(), line.number, modules_}, port_); });
    if (!finished_ && !sensors_missed_.empty() && std::holds_alternative<protocol::RobotState>(line.message))
        askForSensors();
    if (!finished_)
        ask(modules_.geometry, "geometry");
    if (!finished_)
        ask(modules_.configuration, "configuration");
    if (!finished_)
        failForSensors();
    return takeOutput();
}

RunningBehavior::Output BehaviorHost::order(Order order) {
    guarded([&] { behavior_->order(order, port_); });
    return takeOutput();
}

RunningBehavior::Output BehaviorHost::control(const PlanControl& control) {
    guarded([&] { behavior_->control(control, port_); });
    return takeOutput();
}

void BehaviorHost::setParameters(const ParameterSet& parameters) {
    guarded([&] { behavior_->setParameters(parameters); });
}

CausedCommand BehaviorHost::safeCommand(const by::Source& source) const {
    const Cause cause{source, last_line_};
    try {
        return {behavior_->safeCommand(), cause};
    } catch (...) {
        const auto& state = modules_.state.latest();
        return {lastResort(state ? state->kind : protocol::VehicleKind::Unknown), cause};
    }
}

RunningBehavior::Output BehaviorHost::takeOutput() {
    Output output{port_.takeCommands(), port_.takePublished()};
    for (CausedCommand& caused : output.commands)
        addId(caused.cause.source, behavior_id_);
    for (const Published& value : output.published) {
        finished_ = finished_ || std::holds_alternative<BehaviorFinished>(value);
        if (std::holds_alternative<PlanHalted>(value) || std::holds_alternative<PlanResumed>(value))
            halted_ = std::holds_alternative<PlanHalted>(value);
    }
    halted_ = halted_ && !finished_;
    return output;
}

} // namespace usar::agent
