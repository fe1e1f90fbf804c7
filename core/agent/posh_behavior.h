// A behavior that is a plan file and a robot's senses and acts.
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/agent/posh_binding.h"
#include "core/agent/posh_debugger.h"
#include "core/agent/posh_host.h"
#include "core/posh/trace_encoder.h"

namespace usar::agent {

/// What a plan behavior is made of.
struct PoshParts {
    std::string plan_name; ///< of its file, for messages
    std::string plan_text;
    PoshRegistry registry;
    std::unique_ptr<PoshBody> body;
    posh::EngineOptions options; ///< a plan whose goal is reached is finished, whatever they say
};

/// One cycle a tick, on the robot's own clock in whole milliseconds. An act that throws, a plan that spends its budget
/// of acts or a drive that starves is reported by its path, and the robot gets its safe command in that cycle; when no
/// drive is ready it gets it once. Orders that the body does not see to: pause and resume keep the plan where it is;
/// landing stops the plan and gives the safe command. The plan's goal finishes the behavior. What happens is published
/// as PlanTrace at every tick.
///
/// Where a person holds it still no cycle runs, and the robot has its safe command; when it goes on, the last cycle's
/// drive command goes out again, so that a robot whose time stood still does not notice. An order to land lets it go
/// on. A plan of the same shape as the one that runs (see posh::sameShape) takes its place without a break; any other
/// begins at its root, and until it has decided the robot has its safe command.
class PoshBehavior final : public Behavior {
public:
    /// A plan that cannot be read, or does not fit the robot, is an error that lists all that is wrong with it.
    static Result<std::unique_ptr<PoshBehavior>> make(PoshParts parts);
    ~PoshBehavior() override;

    void onInfo(const protocol::InfoLine& line, CommandPort& port) override;
    void tick(const Tick& tick, CommandPort& port) override;
    void order(Order order, CommandPort& port) override;
    void control(const PlanControl& control, CommandPort& port) override;
    void setParameters(const ParameterSet& parameters) override { parts_.body->setParameters(parameters); }
    protocol::Command safeCommand() const override { return parts_.body->safeCommand(); }

    const std::string& planText() const { return parts_.plan_text; }
    const posh::Engine& engine() const { return engine_; }
    /// Null: nobody watches.
    void watch(posh::TraceObserver* observer);

private:
    /// Hears what goes wrong, keeps the trace, and passes everything on.
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

        bool needs_safety = false; ///< in this cycle
        std::vector<BehaviorEvent> events;

    private:
        void report(const posh::TraceRecord& record, std::string_view text);

        posh::TraceEncoder encoder_;
        posh::TraceObserver& debugger_;
        posh::TraceObserver* next_ = nullptr;
        std::shared_ptr<const posh::Program> program_;
        std::set<std::pair<posh::Index, std::string>> reported_; ///< once each
    };

    PoshBehavior(PoshParts parts, std::shared_ptr<const posh::Program> program);
    std::optional<PlanHalted> runCycle(const Tick& tick, CommandPort& port);
    void report(posh::Outcome outcome, CommandPort& port);
    void publishStatus(const Tick& tick, CommandPort& port);
    void land(CommandPort& port);
    void obey(const ReplacePlan& asked, CommandPort& port);
    void obey(const SetBreakpoints& asked, CommandPort& port);
    void obey(const SetPins& asked, CommandPort& port);
    void obey(PlanStep step, CommandPort& port);
    PlanReplaced replacePlan(const PlanText& plan);
    /// What is worth knowing about the plan before it decides.
    void remark(CommandPort& port);
    void standStill(PlanHalted why, CommandPort& port);
    void goOn(CommandPort& port);

    PoshParts parts_;
    PoshHost host_;
    PoshDebugger debugger_;
    Reporter reporter_;
    posh::Engine engine_;
    std::optional<CausedCommand> last_drive_; ///< what the robot is to do when a halted plan goes on
    std::optional<Seconds> began_;
    bool paused_ = false;
    bool idle_ = false;
    bool landing_ = false;
    bool finished_ = false;
};

} // namespace usar::agent
