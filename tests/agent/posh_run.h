// A toy rover that a plan drives, and shorthand for what its behavior publishes.
#pragma once

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/agent/behavior_host.h"
#include "core/agent/posh/posh_behavior.h"
#include "tests/agent/toy_rover.h"

namespace tst_posh_behavior {

using namespace usar;
using namespace usar::agent;
using usar::test::ToyRover;

inline const std::string drive_on = "((DC rover (goal ((Arrived))) (drives ((danger (trigger ((Closer(0.5)))) Halt)) "
                                    "((work DriveFor(10))))))";

/// A behavior in its host, fed with STA lines at 5 Hz.
class Run {
public:
    explicit Run(const std::string& plan) {
        auto body = std::make_unique<ToyRover>();
        rover = body.get();
        auto made = PoshBehavior::make({"rover.lap", plan, test::toyRegistry(), std::move(body), {}});
        if (!made)
            throw std::runtime_error(made.error().text());
        behavior = made->get();
        host = std::make_unique<BehaviorHost>(*std::move(made), "toy/posh");
    }
    BehaviorHost::Output tick() {
        protocol::RobotState state;
        state.time = Seconds(0.2 * static_cast<double>(++ticks_));
        return host->receive({LineNumber{ticks_}, "", state, {}});
    }

    ToyRover* rover = nullptr;
    PoshBehavior* behavior = nullptr;
    std::unique_ptr<BehaviorHost> host;

private:
    std::uint64_t ticks_ = 0;
};

inline protocol::Command wheels(double left, double right) {
    return protocol::SkidDrive{left, right};
}

template <class T>
std::vector<T> published(const BehaviorHost::Output& output) {
    std::vector<T> found;
    for (const Published& value : output.published)
        if (const auto* const one = std::get_if<T>(&value))
            found.push_back(*one);
    return found;
}

/// The only one of its kind.
template <class T>
T thePublished(const BehaviorHost::Output& output) {
    const auto all = published<T>(output);
    return all.size() == 1 ? all.front() : throw std::runtime_error("not one but " + std::to_string(all.size()));
}

inline PlanReplaced replacedBy(Run& run, const std::string& text) {
    return thePublished<PlanReplaced>(run.host->control(ReplacePlan{{"new.lap", text}}));
}

inline SetBreakpoints breakBefore(const std::string& names) {
    posh::Breakpoint breakpoint;
    breakpoint.names = names;
    return {{{7, breakpoint}}};
}

inline std::size_t count(const std::vector<std::string>& calls, const std::string& what) {
    return static_cast<std::size_t>(std::ranges::count(calls, what));
}

} // namespace tst_posh_behavior
