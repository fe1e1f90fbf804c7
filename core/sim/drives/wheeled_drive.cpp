#include "core/sim/drives/wheeled_drive.h"

#include <algorithm>

#include "core/base/text.h"

namespace usar::sim {

namespace {

/// Contacts that press from below, at most 45 degrees off the vertical, are with what the robot stands on.
constexpr double standing_normal_z = 0.7;

std::optional<double> figure(const Numbers& figures, std::string_view key) {
    const auto found = figures.find(key);
    return found == figures.end() ? std::nullopt : std::optional(found->second);
}

} // namespace

WheeledDrive::WheeledDrive(const RobotModel& model, Physics& physics, BodyId body,
                           const std::vector<std::size_t>& wheels)
    : JointDrive(model, physics, body)
    , wheels_(joints_, wheels, numberOr(model.drive.numbers, "acceleration", 0.0))
    , figures_(model.drive.numbers) {}

bool WheeledDrive::obeyJoint(const protocol::Command& command) {
    if (off())
        return false;
    const std::vector<std::size_t> obeying = joints_.obey(command);
    for (const std::size_t joint : obeying)
        wheels_.leave(joint);
    others_moving_ |= !obeying.empty();
    return !obeying.empty();
}

void WheeledDrive::beforeStep(Seconds dt) {
    if (off())
        return;
    wheels_.step(dt);
    others_moving_ = others_moving_ && !joints_.still();
    letSleep(idle());
}

void WheeledDrive::afterStep(Seconds dt) {
    collisions_.pass(dt);
    for (const Contact& contact : physics().contacts(body()))
        if (contact.surface != Surface::Ground && contact.normal_in_map.z() < standing_normal_z)
            collisions_.touch();
}

void WheeledDrive::addTo(protocol::RobotState& state) const {
    state.front_steer_rad = state.rear_steer_rad = 0.0;
}

void WheeledDrive::addTo(protocol::GeometryInfo& geometry) const {
    geometry.wheel_radius_m = figure(figures_, "wheel_radius");
    geometry.wheel_separation_m = figure(figures_, "wheel_separation");
    geometry.wheel_base_m = figure(figures_, "wheel_base");
}

void WheeledDrive::addTo(std::vector<protocol::Setting>& settings) const {
    settings.push_back({"MaxSpeed", "", wheels_.largestSpin()});
    settings.push_back({"MaxTorque", "", wheels_.largestTorque()});
    settings.push_back({"MaxFrontSteer", "", largest_front_rad_});
    settings.push_back({"MaxRearSteer", "", largest_rear_rad_});
}

Result<std::vector<std::size_t>> linksOn(const RobotModel& model, const std::vector<std::string>& joints) {
    std::vector<std::size_t> links;
    for (const std::string& joint : joints) {
        const auto link =
            std::ranges::find_if(model.links, [&](const ModelLink& one) { return sameWord(one.joint, joint); });
        if (link == model.links.end())
            return failure("the drive's joint \"" + joint + "\" does not exist", "robot " + model.class_name,
                           "Name one of the model's joints");
        links.push_back(static_cast<std::size_t>(link - model.links.begin()));
    }
    return links;
}

} // namespace usar::sim
