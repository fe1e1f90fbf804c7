// Where a behavior's answers go: commands with their cause, and published values.
#pragma once

#include <string>
#include <vector>

#include "core/agent/published.h"
#include "core/base/cause.h"
#include "core/protocol/command.h"

namespace usar::agent {

struct CausedCommand {
    protocol::Command command;
    Cause cause;
    bool operator==(const CausedCommand&) const = default;
};

/// Collects what one call of a behavior answers. The owner empties it; nothing is sent while the behavior runs.
class CommandPort {
public:
    /// `source` says which state or plan node decided; the triggering line is stamped by the host.
    void send(protocol::Command command, std::string source);
    void publish(Published value);

    void setTrigger(LineNumber line) { trigger_ = line; }
    std::vector<CausedCommand> takeCommands();
    std::vector<Published> takePublished();

private:
    LineNumber trigger_;
    std::vector<CausedCommand> commands_;
    std::vector<Published> published_;
};

} // namespace usar::agent
