// A behavior that consists of a plan and a robot's senses and acts.
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/agent/posh/posh_binding.h"
#include "core/agent/posh/posh_debugger.h"
#include "core/agent/posh/posh_host.h"
#include "core/posh/trace/trace_encoder.h"

namespace usar::agent {

/// The parts of a plan behavior.
struct PoshParts {
    std::string plan_name; ///< file name, for messages
    std::string plan_text;
    PoshRegistry registry;
    std::unique_ptr<PoshBody> body;
    posh::EngineOptions options; ///< except `on_goal`: reaching the goal always ends the behavior
};

/// Runs one cycle per tick, on the protocol's clock in whole milliseconds. If an act throws, the plan exhausts its
/// budget of acts or a drive starves, this is reported with the path, and the robot gets its safe command in that
/// cycle. If no drive is ready, it gets the safe command once. Orders that the body does not handle have a default
/// effect: pause and resume keep the plan's position; landing stops the plan and sends the safe command. Reaching the
/// plan's goal finishes the behavior. Each tick publishes the events as PlanTrace.
///
/// While the plan is halted by the operator, no cycle runs and the robot has its safe command. When the plan continues,
/// the last cycle's drive command is sent again, so that a robot whose time stood still does not notice the halt. An
/// order to land also continues the plan. A new plan of the same shape as the running one (see posh::sameShape)
/// replaces it without interruption; any other begins at its root, and the robot has its safe command until the plan
/// decides.
class PoshBehavior final : public Behavior {
public:
    /// Returns an error that lists all problems if the plan cannot be read or does not fit the robot.
    static Result<std::unique_ptr<PoshBehavior>> make(PoshParts parts);
    ~PoshBehavior() override;

    void onInfo(const protocol::InfoLine& line, CommandPort&) override { parts_.body->onInfo(line); }
    void tick(const Tick& tick, CommandPort& port) override;
    void order(Order order, CommandPort& port) override;
    void control(const PlanControl& control, CommandPort& port) override;
    void setParameters(const ParameterSet& parameters) override { parts_.body->setParameters(parameters); }
    protocol::Command safeCommand() const override { return parts_.body->safeCommand(); }

    const std::string& planText() const { return parts_.plan_text; }
    const posh::Engine& engine() const { return engine_; }
    /// Sets an additional observer of the trace, which must outlive this object; nullptr removes it.
    void watch(posh::TraceObserver* observer) { reporter_.watch(observer); }

private:
    /// Turns errors and warnings into events, keeps the trace, and passes all records on.
    class Reporter final : public posh::TraceObserver {
    public:
        Reporter(std::string plan_text, posh::TraceObserver& debugger)
            : encoder_(std::move(plan_text))
            , debugger_(debugger) {}
        void takeProgram(const std::shared_ptr<const posh::Program>& program) override;
        void take(const posh::TraceRecord& record, std::string_view text) override;
        void watch(posh::TraceObserver* observer);

        void setPlanText(std::string text) { encoder_.setPlanText(std::move(text)); }
        std::string takeTrace() { return encoder_.takeBytes(); }

        bool needs_safety = false; ///< the robot needs its safe command in this cycle
        std::vector<BehaviorEvent> events;

    private:
        void report(const posh::TraceRecord& record, std::string_view text);

        posh::TraceEncoder encoder_;
        posh::TraceObserver& debugger_;
        posh::TraceObserver* next_ = nullptr;
        std::shared_ptr<const posh::Program> program_;
        std::set<std::pair<posh::Index, std::string>> reported_; ///< by place and text; each is reported once
    };

    PoshBehavior(PoshParts parts, std::shared_ptr<const posh::Program> program);
    /// Runs one cycle of the plan. Returns the reason if the plan halts after it.
    std::optional<PlanHalted> runCycle(const Tick& tick, CommandPort& port);
    /// Publishes the events of the cycle, and the end of the behavior once it has ended.
    void report(posh::Outcome outcome, CommandPort& port);
    void publishStatus(const Tick& tick, CommandPort& port);
    /// The default effect of the order to land.
    void land(CommandPort& port);
    void obey(const ReplacePlan& asked, CommandPort& port);
    void obey(const SetBreakpoints& asked, CommandPort& port);
    void obey(const SetPins& asked, CommandPort&) { debugger_.set(asked, engine_); }
    void obey(PlanStep step, CommandPort& port);
    PlanReplaced replacePlan(const PlanText& plan);
    /// Publishes a note if the plan asks for real time.
    void remark(CommandPort& port);
    /// Continues a halted plan; no effect otherwise.
    void goOn(CommandPort& port);

    PoshParts parts_;
    PoshHost host_;
    PoshDebugger debugger_;
    Reporter reporter_;
    posh::Engine engine_;
    std::optional<CausedCommand> last_drive_; ///< sent again when a halted plan continues
    std::optional<Seconds> began_;            ///< time of the first tick
    bool paused_ = false;                     ///< by an order
    bool idle_ = false;                       ///< no drive was ready in the last cycle
    bool landing_ = false;                    ///< the plan was stopped by the order to land
    bool finished_ = false;
};

} // namespace usar::agent
