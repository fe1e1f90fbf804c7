// The smallest robot with senses and acts: it stops for what is near and otherwise drives on.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "core/agent/posh_primitives.h"

namespace usar::test {

class ToyRover final : public agent::PoshBody {
public:
    double nearest_m = 10.0;
    bool arrived = false;
    bool broken = false;
    bool lands = false;
    std::vector<std::string> calls;

    void begin(const agent::Tick&) override { calls.emplace_back("begin"); }
    void end(const agent::Tick&) override { calls.emplace_back("end"); }
    bool order(agent::Order) override { return lands; }
    protocol::Command safeCommand() const override { return protocol::SkidDrive{0.0, 0.0}; }
};

/// Drives for so long; stops when it is done.
class DriveFor {
public:
    void init(ToyRover& rover, const agent::PoshArguments&) {
        rover.calls.emplace_back("init");
        began_ = rover.now();
    }
    posh::ActResult run(ToyRover& rover, const agent::PoshArguments& arguments) {
        if (rover.broken)
            throw std::runtime_error("the wheels are off");
        rover.drive(protocol::SkidDrive{1.0, 1.0});
        const bool over = (rover.now() - began_).count() >= arguments.real("time");
        return over ? posh::ActResult::RunningOnce : posh::ActResult::Running;
    }
    void done(ToyRover& rover, const agent::PoshArguments&, posh::DoneReason) { rover.calls.emplace_back("done"); }

private:
    Seconds began_{0.0};
};

inline agent::PoshRegistry toyRegistry() {
    using agent::PoshArguments;
    using agent::PoshParameter;
    agent::PoshRegistry registry;
    agent::PoshPrimitives<ToyRover> rover(registry);
    rover.sense("Nearest", [](const ToyRover& body) { return body.nearest_m; })
        .unit("m")
        .describe("Distance of what is nearest.")
        .needs("RangeScanner");
    rover
        .sense("Closer",
               [](const ToyRover& body, const PoshArguments& than) { return body.nearest_m < than.real("than"); })
        .takes(PoshParameter::number("than", 0.5, "m", 0.0, 20.0));
    rover.sense("Arrived", [](const ToyRover& body) { return body.arrived; });
    rover.sense("Count", [](const ToyRover& body) { return body.read("count"); });
    rover.act("Halt", [](ToyRover& body) { body.drive(protocol::SkidDrive{0.0, 0.0}); });
    rover.act("Tick", [](ToyRover& body) {
        const auto* const count = std::get_if<std::int64_t>(&body.read("count"));
        body.write("count", (count ? *count : 0) + 1);
        body.drive(protocol::SkidDrive{0.5, 0.5});
        return posh::ActResult::Finished;
    });
    rover.act("Refuse", [](ToyRover&) { return false; });
    rover
        .act("Turn",
             [](ToyRover& body, const PoshArguments& arguments) {
                 const double sign = arguments.text("side") == "left" ? 1.0 : -1.0;
                 body.drive(protocol::SkidDrive{-sign, sign});
             })
        .takes(PoshParameter::symbol("side", "left", {"left", "right"}));
    rover.act<DriveFor>("DriveFor").takes(PoshParameter::number("time", 1.0, "s", 0.0, 60.0));
    return registry;
}

} // namespace usar::test
