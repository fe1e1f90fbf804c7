// A behavior at work, wherever it runs: in the caller's thread, in one of its own, or in a process of its own.
#pragma once

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

#include "core/agent/behavior.h"

namespace usar::agent {

/// Lines and orders go in, caused commands and published values come out; each call waits for the answer, so that a
/// mission is the same wherever its behavior runs. One that fails, hangs or dies says BehaviorFinished with the reason,
/// after its safe command, and is not called again; where the reason must be found out first, `ending` is true before.
/// Used from its owner's thread.
class RunningBehavior {
public:
    struct Output {
        std::vector<CausedCommand> commands;
        std::vector<Published> published;

        void append(Output later) {
            std::ranges::move(later.commands, std::back_inserter(commands));
            std::ranges::move(later.published, std::back_inserter(published));
        }
    };

    virtual ~RunningBehavior() = default;

    /// Once, before the first line: what takes time, such as the start of a process.
    virtual Output begin() { return {}; }
    virtual Output receive(const protocol::InfoLine& line) = 0;
    virtual Output order(Order order) = 0;
    virtual Output control(const PlanControl& control) = 0;
    /// What goes wrong by it comes out of the next call.
    virtual void setParameters(const ParameterSet& parameters) = 0;
    /// What makes the robot safe, with `source` as its cause. Never waits for the behavior.
    virtual CausedCommand safeCommand(const std::string& source) const = 0;

    /// Its plan stands still: time should, too.
    virtual bool halted() const = 0;
    virtual bool finished() const = 0;
    /// It is gone, and nobody knows why yet: the robot is to be made safe now, and then `takeEnd` finds out, which may
    /// take half a second.
    virtual bool ending() const { return false; }
    /// It ended by a fault of its own (it threw, hung or died), and not by what it had to say.
    virtual bool broke() const { return false; }
    virtual const std::string& behaviorId() const = 0;

    /// How long an answer may take, of wall time, before the behavior counts as hanging. Before `begin`.
    virtual void setPatience(Seconds) {}
    /// A file descriptor that can be read from when it has ended between two calls; then ask `takeEnd`. Below 0: it
    /// ends in its calls only.
    virtual int endHandle() const { return -1; }
    virtual Output takeEnd() { return {}; }
};

/// A DRIVE of zeros, for a robot on the ground, in the water or in the air, where the behavior cannot even say that.
protocol::Command lastResort(protocol::VehicleKind kind);

} // namespace usar::agent
