// A gripper: fingers that close with a limited force. What it holds it holds by the friction of the contacts.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/protocol/command.h"
#include "core/protocol/info/answers.h"
#include "core/protocol/info/packages.h"
#include "core/sim/robots/robot_body.h"

namespace usar::sim {

/// Its fingers are open while their joints are at 0, and closed at the other end of their range; a thing between them
/// stops them earlier, and they go on pressing with their effort. `body` must outlive it.
class Gripper {
public:
    Gripper(const GripperModel& model, RobotBody& body);

    const std::string& name() const { return model_.name; }
    /// Obeys SET of a gripper. An empty name means every gripper. Returns nullopt for other commands and grippers.
    std::optional<protocol::Response> set(const protocol::Command& command);
    /// Obeys the part of MISPKG and ACT that closes and opens the gripper of a package.
    void obey(const protocol::Command& command);
    /// Turns the fingers' motors off.
    void switchOff();

    /// EFF, which UDK sends at each tick.
    protocol::EffecterState state(Seconds now) const { return {now, "Gripper", name(), closed_, {}, {}, {}}; }
    protocol::MountedItem geometry() const;
    /// Its opcodes, as a UDK server tells them.
    std::vector<protocol::Setting> settings() const;

private:
    void close(bool closed);

    GripperModel model_;
    RobotBody& body_;
    std::vector<std::size_t> links_; ///< the fingers
    bool closed_ = false;
};

} // namespace usar::sim
