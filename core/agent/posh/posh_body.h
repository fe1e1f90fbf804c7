// The state that the senses and acts of one robot share during a run: the tick's data, the plan's blackboard, and the
// output for commands.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "core/agent/behavior.h"
#include "core/posh/run/engine.h"

namespace usar::agent {

/// Each robot derives its own body and adds the data of its senses and acts. Senses get a const body, so that they
/// cannot change anything. Exists as long as the behavior and is used in its thread; restarts of the plan do not change
/// it.
class PoshBody {
public:
    virtual ~PoshBody() = default;

    /// For senses: the time of the tick, on the protocol's clock.
    Seconds now() const { return now_; }
    std::uint64_t cycle() const { return cycle_; }
    /// Valid only during a cycle and in `begin` and `end`.
    const modules::RobotModules& modules() const { return *modules_; }
    /// The value of a key on the blackboard; nil if it was never written.
    const posh::Value& read(const std::string& key) const;

    /// For acts. Of the drive commands in a cycle only the last is sent; other commands are sent at once. Outside a
    /// tick, commands and published values are discarded.
    modules::RobotModules& modules() { return *modules_; }
    /// `why` stands beside the path of the act in the command's cause: "scanning lane 1 of 4".
    void drive(protocol::Command command, std::string_view why = {});
    void send(protocol::Command command, std::string_view why = {});
    void publish(Published value);
    /// Writes a key of the blackboard, which views show and traces record.
    void write(const std::string& key, posh::Value value);

    /// Called with every info line, before the tick that the line may cause.
    virtual void onInfo(const protocol::InfoLine&) {}
    /// Called before and after the cycle of each tick, also while paused.
    virtual void begin(const Tick&) {}
    virtual void end(const Tick&) {}
    /// Return true if the robot handles the order itself (its senses inform the plan) and cycles continue; false for
    /// the default effect, see PoshBehavior.
    virtual bool order(Order) { return false; }
    virtual void setParameters(const ParameterSet&) {}
    /// Completes the values for the status strip; the times and the path of the current act are already set.
    virtual void describe(BehaviorStatus&) const {}
    /// Return a value to end the behavior, whatever the plan says; called after each cycle.
    virtual std::optional<BehaviorFinished> ended() const { return std::nullopt; }
    /// The final message if the plan's goal is reached.
    virtual BehaviorFinished finished() const { return {true, "The goal of the plan is reached."}; }
    /// See Behavior::safeCommand.
    virtual protocol::Command safeCommand() const = 0;

private:
    friend class PoshBehavior;
    friend class PoshHost;

    void note(posh::TraceEvent event, std::string_view text);
    /// The path of the sense or act being called, and the reason, for the cause of a command.
    by::Plan source(std::string_view why) const;
    /// Sends the last drive command of the cycle.
    void sendDrive();

    posh::Engine* engine_ = nullptr;
    CommandPort* port_ = nullptr; ///< during a tick only, like the next one
    modules::RobotModules* modules_ = nullptr;
    posh::Index place_ = 0; ///< place of the sense or act being called
    Seconds now_{0.0};
    std::uint64_t cycle_ = 0;
    std::optional<protocol::Command> drive_;
    by::Plan drive_source_;
    std::map<std::string, posh::Value> blackboard_;
};

} // namespace usar::agent
