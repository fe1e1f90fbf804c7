// The robot's state: the newest STA, and the protocol clock that behaviors live by.
#pragma once

#include <optional>

#include "core/protocol/info_message.h"

namespace usar::modules {

/// Fed by its owner with every info line; a value otherwise.
class StateModule {
public:
    void take(const protocol::InfoLine& line);

    /// Nothing until the first STA.
    const std::optional<protocol::RobotState>& latest() const { return latest_; }
    LineNumber line() const { return line_; }
    /// Time of the newest STA; zero before it. Never runs backward.
    Seconds now() const { return now_; }

private:
    std::optional<protocol::RobotState> latest_;
    LineNumber line_;
    Seconds now_{0.0};
};

} // namespace usar::modules
