// What the senses and acts of one robot share during a run: the tick's data, plan state, and the way out for commands.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "core/agent/behavior.h"
#include "core/posh/engine.h"

namespace usar::agent {

/// A robot derives its own and adds what its senses and acts work with. Senses see it const: one that changes anything
/// does not compile. Lives as long as its behavior, on its thread; restarts of the plan leave it as it is.
class PoshBody {
public:
    virtual ~PoshBody();

    /// For senses.
    Seconds now() const { return now_; }
    std::uint64_t cycle() const { return cycle_; }
    /// Valid in a cycle and in `begin` and `end` only.
    const modules::RobotModules& modules() const { return *modules_; }
    /// Nil for what was never written.
    const posh::Value& read(const std::string& key) const;

    /// For acts. At most one drive command leaves in a cycle: the last. Others leave as they come. Outside of a tick
    /// nobody listens.
    modules::RobotModules& modules() { return *modules_; }
    /// `why` follows the path of the act in the cause of the command: "scanning lane 1 of 4".
    void drive(protocol::Command command, std::string_view why = {});
    void send(protocol::Command command, std::string_view why = {});
    void publish(Published value);
    /// Plan state that views show and traces keep.
    void write(const std::string& key, posh::Value value);

    /// Every info line, before the tick that it may cause.
    virtual void onInfo(const protocol::InfoLine&) {}
    /// Around the cycle of each tick, also while paused.
    virtual void begin(const Tick&) {}
    virtual void end(const Tick&) {}
    /// True: the robot sees to it (senses tell the plan), and cycles go on. False: the usual is done, see PoshBehavior.
    virtual bool order(Order) { return false; }
    virtual void setParameters(const ParameterSet&) {}
    /// Completes what the status strip shows; time and the path of the current act are there already.
    virtual void describe(BehaviorStatus&) const {}
    /// The robot's own end, which ends the behavior whatever the plan says; asked after each cycle.
    virtual std::optional<BehaviorFinished> ended() const { return std::nullopt; }
    /// What is said when the plan's goal holds.
    virtual BehaviorFinished finished() const { return {true, "The goal of the plan is reached."}; }
    virtual protocol::Command safeCommand() const = 0;

private:
    friend class PoshBehavior;
    friend class PoshHost;

    void note(posh::TraceEvent event, std::string_view text);
    std::string source(std::string_view why) const;
    void sendDrive();

    /// While it lives, the tick's data are at hand and somebody listens.
    class Opening {
    public:
        Opening(PoshBody& body, const Tick& tick, CommandPort& port);
        ~Opening();
        Opening(const Opening&) = delete;
        Opening& operator=(const Opening&) = delete;

    private:
        PoshBody& body_;
    };

    posh::Engine* engine_ = nullptr;
    CommandPort* port_ = nullptr;
    modules::RobotModules* modules_ = nullptr;
    posh::Index place_ = 0; ///< of the sense or act that is called
    Seconds now_{0.0};
    std::uint64_t cycle_ = 0;
    std::optional<protocol::Command> drive_;
    std::string drive_source_;
    std::map<std::string, posh::Value> blackboard_;
};

} // namespace usar::agent
