// A robot plugin for tests of missions: its behavior scans for some ticks where it stands, then ends as it was told.
#include <stdexcept>

#include <QObject>

#include "core/agent/posh/posh_behavior.h"
#include "core/agent/robot_plugin.h"
#include "tests/agent/toy_rover.h"

namespace {

using namespace usar;
using namespace usar::agent;

class Hop : public Behavior {
public:
    explicit Hop(BehaviorContext context) : context_(std::move(context)) {}

    void tick(const Tick& tick, CommandPort& port) override {
        const long long ticks = context_.parameters.integer("ticks");
        ++ticks_;
        port.send(protocol::AerialDrive{.climb_m_s = 1.0}, "hopping");
        if (const auto* scan = tick.robot.sensors.scan()) {
            Pose down;
            down.position_m = {context_.task.area_in_map.center_m().x(), context_.task.area_in_map.center_m().y(), 5.0};
            down.pitch_rad = pi / 2;
            port.publish(ScanPlacement{scan->line, down});
        }
        BehaviorStatus status;
        status.state = "hop " + std::to_string(ticks_);
        status.progress_pct = 100.0 * static_cast<double>(ticks_) / static_cast<double>(ticks);
        status.distance_flown_m = static_cast<double>(ticks_);
        status.charges = 1;
        port.publish(status);
        if (ticks_ >= ticks)
            port.publish(BehaviorFinished{context_.parameters.flag("succeeds"), "Hopped enough."});
    }
    void order(Order, CommandPort&) override {}
    void setParameters(const ParameterSet&) override {}
    protocol::Command safeCommand() const override { return protocol::AerialDrive{0.0, 0.0, 0.0, 0.0}; }

private:
    BehaviorContext context_;
    long long ticks_ = 0;
};

Result<std::unique_ptr<Behavior>> plannedBehavior(BehaviorContext context) {
    const PlanText plan = context.plan.value_or(PlanText{"toy.lap", "((DC toy (drives ((rest Halt)))))"});
    auto made = PoshBehavior::make({plan.name, plan.text, test::toyRegistry(), std::make_unique<test::ToyRover>(), {}});
    if (!made)
        return tl::unexpected(made.error());
    return *std::move(made);
}

class HopPlugin : public QObject, public RobotPlugin {
    Q_OBJECT
    Q_PLUGIN_METADATA(IID "org.usar.mission.RobotPlugin/9" FILE "hop_plugin.json")
    Q_INTERFACES(usar::agent::RobotPlugin)
public:
    RobotDescription description() const override {
        BehaviorDescription hop;
        hop.id = "test/hop";
        hop.name = "Hop";
        hop.needs_area = true;
        hop.parameters = {{"ticks", "Ticks", "", "", 5LL, 1, 1000000, "How long.", {}},
                          {"lean_rad", "Lean", "", "rad", 0.0, 0.0, pi / 4, "Only to be checked.", {}},
                          {"throws", "Throws", "", "", false, 0, 0, "Instead of being made.", {}},
                          {"succeeds", "Succeeds", "", "", true, 0, 0, "How it ends.", {}}};
        hop.presets = {{"long", "Long", "Hops often.", {{"ticks", 500LL}, {"lean_rad", 0.5}}},
                       {"low", "Low", "Hops twice.", {{"ticks", 2LL}}}};
        BehaviorDescription planned;
        planned.id = "test/planned";
        planned.name = "Planned";
        planned.plan_name = "toy.lap";
        planned.plan_text = "((DC toy (drives ((rest Halt)))))";
        return {"USARBot.AirRobot", "Hopper", {}, {hop, planned}, test::toyRegistry().descriptions()};
    }
    Result<std::unique_ptr<Behavior>> createBehavior(const std::string& id, BehaviorContext context) const override {
        if (id == "test/planned")
            return plannedBehavior(std::move(context));
        if (id != "test/hop")
            return failure("no such behavior", id);
        if (context.parameters.flag("throws"))
            throw std::runtime_error("no rotor");
        return std::make_unique<Hop>(std::move(context));
    }
};

} // namespace

#include "hop_plugin.moc"
