// Collects a behavior's output: commands with their causes, and published values.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/agent/published.h"
#include "core/base/cause.h"
#include "core/protocol/command.h"

namespace usar::agent {

/// A command and the reason why it is sent.
struct CausedCommand {
    protocol::Command command;
    Cause cause;
    bool operator==(const CausedCommand&) const = default;
};

/// Collects the output of one call of a behavior. The owner empties it afterwards; nothing is sent during the call.
class CommandPort {
public:
    /// `state` is what the behavior was doing when it decided; the host adds the behavior's id.
    void send(protocol::Command command, std::string state) {
        send(std::move(command), by::Behavior{{}, std::move(state)});
    }
    void send(protocol::Command command, by::Source source) {
        commands_.push_back({std::move(command), {std::move(source), trigger_}});
    }
    /// Values are delivered in the order of publication.
    void publish(Published value) { published_.push_back(std::move(value)); }

    /// Sets the line that counts as the trigger of the commands that follow.
    void setTrigger(LineNumber line) { trigger_ = line; }
    /// Return what has been collected, in order, and empty the port.
    std::vector<CausedCommand> takeCommands() { return std::exchange(commands_, {}); }
    std::vector<Published> takePublished() { return std::exchange(published_, {}); }

private:
    LineNumber trigger_;
    std::vector<CausedCommand> commands_;
    std::vector<Published> published_;
};

} // namespace usar::agent
