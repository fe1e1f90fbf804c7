#include "core/sim/robots/gripper.h"

#include <algorithm>
#include <cmath>

#include "core/base/text.h"

namespace usar::sim {

Gripper::Gripper(const GripperModel& model, RobotBody& body) : model_(model), body_(body) {
    for (const std::string& joint : model_.joints)
        links_.push_back(static_cast<std::size_t>(body.model().linkOnJoint(joint).value_or(0)));
    close(false);
}

/// The joints' 0 is open; the end of the range that is farther from it is closed.
void Gripper::close(bool closed) {
    closed_ = closed;
    for (const std::size_t link : links_) {
        const LinkDescription& finger = body_.model().body.links[link];
        const double shut = std::abs(finger.upper) > std::abs(finger.lower) ? finger.upper : finger.lower;
        const ModelLink& limits = body_.model().links[link];
        body_.physics().setMotor(
            body_.id(), link,
            {JointMotor::Mode::Position, closed ? shut : 0.0, limits.torque_limit, limits.speed_limit});
    }
}

std::optional<protocol::Response> Gripper::set(const protocol::Command& command) {
    const auto* const wanted = std::get_if<protocol::UseGripper>(&command);
    if (!wanted || !(wanted->gripper_name.empty() || sameWord(wanted->gripper_name.text(), name())))
        return std::nullopt;
    close(wanted->action == protocol::GripperAction::Close || wanted->action == protocol::GripperAction::Grip);
    return protocol::Response{{}, "Gripper", name(), true};
}

void Gripper::obey(const protocol::Command& command) {
    std::optional<bool> closed;
    if (const auto* const drive = std::get_if<protocol::PackageDrive>(&command);
        drive && sameWord(drive->package.text(), model_.package))
        closed = drive->gripper_closed;
    if (const auto* const actuator = std::get_if<protocol::ActuatorDrive>(&command);
        actuator && sameWord(actuator->actuator.text(), model_.package))
        closed = actuator->gripper_closed;
    if (closed)
        close(*closed);
}

void Gripper::switchOff() {
    for (const std::size_t link : links_)
        body_.physics().setMotor(body_.id(), link, {});
}

protocol::MountedItem Gripper::geometry() const {
    const RobotModel& model = body_.model();
    const int holder = model.body.links[links_.front()].parent;
    if (holder < 0)
        return {name(), Pose{}, "HARD", model_.tip_in_holder_m};
    const ModelLink& link = model.links[static_cast<std::size_t>(holder)];
    const auto package = std::ranges::find(model.packages, model_.package, &PackageModel::name);
    if (package == model.packages.end())
        return {name(), Pose{}, link.name, model_.tip_in_holder_m};
    const auto joint = std::ranges::find(package->joints, link.joint);
    const auto number = joint - package->joints.begin() + 1;
    return {name(), Pose{}, package->name + "_Link" + std::to_string(number), model_.tip_in_holder_m};
}

std::vector<protocol::Setting> Gripper::settings() const {
    return {{"Opcode", "Grip", {}},
            {"MaxVal", "1", 1.0},
            {"MinVal", "0", 0.0},
            {"Opcode", "Close", {}},
            {"Opcode", "Open", {}}};
}

} // namespace usar::sim
