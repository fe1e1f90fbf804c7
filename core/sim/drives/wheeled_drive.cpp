#include "core/sim/drives/wheeled_drive.h"

#include "core/base/text.h"

namespace usar::sim {

namespace {

/// Contacts that press from below, at most 45 degrees off the vertical, are with what the robot stands on.
constexpr double standing_normal_z = 0.7;

std::optional<double> figure(const RobotModel& model, std::string_view key) {
    const auto found = model.drive.numbers.find(key);
    return found == model.drive.numbers.end() ? std::nullopt : std::optional(found->second);
}

} // namespace

WheeledDrive::WheeledDrive(const RobotModel& model, Physics& physics, BodyId body,
                           const std::vector<std::size_t>& wheels)
    : joints_(model, physics, body)
    , wheels_(joints_, wheels, numberOr(model.drive.numbers, "acceleration", 0.0))
    , physics_(physics)
    , body_(body)
    , wheel_radius_m_(figure(model, "wheel_radius"))
    , wheel_separation_m_(figure(model, "wheel_separation"))
    , wheel_base_m_(figure(model, "wheel_base")) {}

bool WheeledDrive::obeyJoint(const protocol::Command& command) {
    if (off_)
        return false;
    const std::vector<std::size_t> obeying = joints_.obey(command);
    for (const std::size_t joint : obeying)
        wheels_.leave(joint);
    others_moving_ |= !obeying.empty();
    return !obeying.empty();
}

void WheeledDrive::beforeStep(Seconds dt) {
    if (off_)
        return;
    wheels_.step(dt);
    others_moving_ = others_moving_ && !joints_.still();
    if (idle() != may_sleep_) {
        may_sleep_ = idle();
        physics_.letSleep(body_, may_sleep_);
    }
}

void WheeledDrive::afterStep(Seconds dt) {
    collisions_.pass(dt);
    for (const Contact& contact : physics_.contacts(body_))
        if (contact.surface != Surface::Ground && contact.normal_in_map.z() < standing_normal_z)
            collisions_.touch();
}

void WheeledDrive::switchOff() {
    off_ = true;
    joints_.releaseAll();
    physics_.letSleep(body_, true);
}

void WheeledDrive::addTo(protocol::RobotState& state) const {
    state.front_steer_rad = frontSteer_rad();
    state.rear_steer_rad = rearSteer_rad();
}

void WheeledDrive::addTo(protocol::GeometryInfo& geometry) const {
    geometry.wheel_radius_m = wheel_radius_m_;
    geometry.wheel_separation_m = wheel_separation_m_;
    geometry.wheel_base_m = wheel_base_m_;
}

void WheeledDrive::addTo(std::vector<protocol::Setting>& settings) const {
    settings.push_back({"MaxSpeed", "", wheels_.largestSpin()});
    settings.push_back({"MaxTorque", "", wheels_.largestTorque()});
    settings.push_back({"MaxFrontSteer", "", largestFrontSteer_rad()});
    settings.push_back({"MaxRearSteer", "", largestRearSteer_rad()});
}

Result<std::vector<std::size_t>> linksOn(const RobotModel& model, const std::vector<std::string>& joints) {
    std::vector<std::size_t> links;
    for (const std::string& joint : joints) {
        std::size_t link = 0;
        while (link < model.links.size() && !sameWord(model.links[link].joint, joint))
            ++link;
        if (link == model.links.size())
            return failure("the drive's joint \"" + joint + "\" is not there", "robot " + model.class_name,
                           "Name one of the model's joints");
        links.push_back(link);
    }
    return links;
}

} // namespace usar::sim
