#include "core/agent/command_port.h"

#include <utility>

namespace usar::agent {

void CommandPort::send(protocol::Command command, std::string state) {
    send(std::move(command), by::Behavior{{}, std::move(state)});
}

void CommandPort::send(protocol::Command command, by::Source source) {
    commands_.push_back({std::move(command), {std::move(source), trigger_}});
}

void CommandPort::publish(Published value) {
    published_.push_back(std::move(value));
}

std::vector<CausedCommand> CommandPort::takeCommands() {
    return std::exchange(commands_, {});
}

std::vector<Published> CommandPort::takePublished() {
    return std::exchange(published_, {});
}

} // namespace usar::agent
