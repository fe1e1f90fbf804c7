#include "core/sim/drives/driven_joints.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/text.h"

namespace usar::sim {

namespace {

constexpr double still_rad_s = 0.02;

using protocol::JointOpcode;
using protocol::JointOrder;

/// True for the joints of mission packages and grippers.
bool isInPackage(const RobotModel& model, const std::string& joint) {
    const auto has = [&](const auto& part) { return std::ranges::find(part.joints, joint) != part.joints.end(); };
    return std::ranges::any_of(model.packages, has) || std::ranges::any_of(model.grippers, has);
}

/// What an opcode other than Stiffness orders; the rows are in the order of the opcodes.
JointOrder orderOf(JointOpcode opcode) {
    using enum JointOrder;
    constexpr std::array orders{Angle, Speed, Torque, RelativeAngle, RelativeSpeed, RelativeTorque};
    return orders.at(static_cast<std::size_t>(opcode));
}

constexpr Seconds standing{1.0};

} // namespace

DrivenJoints::DrivenJoints(const RobotModel& model, Physics& physics, BodyId body) : physics_(physics), body_(body) {
    std::vector<Eigen::Isometry3d> links_in_base;
    for (std::size_t i = 0; i < model.body.links.size(); ++i) {
        const LinkDescription& link = model.body.links[i];
        const Eigen::Isometry3d link_in_parent = link.link_in_parent.isometry();
        links_in_base.push_back(
            link.parent < 0 ? link_in_parent
                            : Eigen::Isometry3d(links_in_base[static_cast<std::size_t>(link.parent)] * link_in_parent));
        const ModelLink& named = model.links[i];
        Joint joint{named.joint, named.torque_limit, named.speed_limit, link.lower, link.upper};
        joint.in_package = isInPackage(model, named.joint);
        joint.pivot_in_base_m = links_in_base.back() * link.pivot_in_link_m;
        joint.axis_in_base = links_in_base.back().linear() * link.axis_in_link;
        joints_.push_back(std::move(joint));
    }
}

std::optional<std::size_t> DrivenJoints::find(std::string_view joint) const {
    const auto found = std::ranges::find_if(joints_, [&](const Joint& one) { return sameWord(one.name, joint); });
    return found == joints_.end() ? std::nullopt : std::optional<std::size_t>(found - joints_.begin());
}

std::vector<std::size_t> DrivenJoints::obey(const protocol::Command& command) {
    std::vector<std::size_t> obeying;
    if (const auto* one = std::get_if<protocol::JointDrive>(&command)) {
        const auto joint = find(one->joint);
        if (joint && one->value && obey(*joint, one->order, *one->value, one->normalized))
            obeying.push_back(*joint);
    } else if (const auto* several = std::get_if<protocol::MultiDrive>(&command)) {
        for (const protocol::JointAngleTarget& target : several->joints)
            if (const auto joint = find(target.joint);
                joint && obey(*joint, JointOrder::Angle, target.angle_rad, false))
                obeying.push_back(*joint);
    } else if (const auto* set = std::get_if<protocol::SetJoint>(&command)) {
        obeying = obeySet(*set);
    }
    return obeying;
}

std::vector<std::size_t> DrivenJoints::obeySet(const protocol::SetJoint& wanted) {
    std::vector<std::size_t> obeying;
    const bool all = sameWord(wanted.joint.text(), "AllAngles") || sameWord(wanted.joint.text(), "AllJoints");
    for (std::size_t i = 0; i < joints_.size(); ++i)
        if ((all ? !joints_[i].in_package : sameWord(joints_[i].name, wanted.joint)) && obeySet(i, wanted))
            obeying.push_back(i);
    return obeying;
}

bool DrivenJoints::obeySet(std::size_t joint, const protocol::SetJoint& wanted) {
    if (wanted.opcode != JointOpcode::Stiffness)
        return obey(joint, orderOf(wanted.opcode), wanted.value, false);
    if (std::isnan(wanted.value) || joints_[joint].torque_limit <= 0.0)
        return false;
    joints_[joint].stiffness = std::clamp(wanted.value, 0.0, 1.0);
    drive(joint, joints_[joint].motor);
    return true;
}

bool DrivenJoints::obey(std::size_t joint, JointOrder order, double value, bool normalized) {
    const Joint& known = joints_[joint];
    if (known.torque_limit <= 0.0 || std::isnan(value))
        return false;
    const JointState now = state(joint);
    switch (order) {
    case JointOrder::Angle:
        hold(joint, value);
        break;
    case JointOrder::RelativeAngle:
        hold(joint, now.position + value);
        break;
    case JointOrder::Speed:
        spin(joint, limited(value, known.speed_limit, normalized));
        break;
    case JointOrder::RelativeSpeed:
        spin(joint, now.velocity + value);
        break;
    case JointOrder::Torque:
        push(joint, limited(value, known.torque_limit, normalized));
        break;
    case JointOrder::RelativeTorque: {
        const bool pushes = known.motor.mode == JointMotor::Mode::Torque;
        push(joint, (pushes ? known.motor.target : 0.0) + value);
        break;
    }
    case JointOrder::Brake:
        drive(joint, {JointMotor::Mode::Velocity, 0.0, std::abs(limited(value, known.torque_limit, normalized)),
                      known.speed_limit});
        break;
    }
    return true;
}

void DrivenJoints::hold(std::size_t joint, double position) {
    const Joint& known = joints_[joint];
    const bool limited = known.lower <= known.upper;
    const double target = limited ? std::clamp(position, known.lower, known.upper) : position;
    drive(joint, {JointMotor::Mode::Position, target, known.torque_limit, known.speed_limit});
}

void DrivenJoints::spin(std::size_t joint, double speed) {
    const Joint& known = joints_[joint];
    drive(joint, {JointMotor::Mode::Velocity, limited(speed, known.speed_limit, false), known.torque_limit,
                  known.speed_limit});
}

void DrivenJoints::push(std::size_t joint, double torque) {
    const Joint& known = joints_[joint];
    drive(joint, {JointMotor::Mode::Torque, limited(torque, known.torque_limit, false), known.torque_limit,
                  known.speed_limit});
}

void DrivenJoints::holdFree() {
    for (std::size_t i = 0; i < joints_.size(); ++i)
        if (isFree(joints_[i]))
            hold(i, 0.0);
}

void DrivenJoints::releaseAll() {
    for (std::size_t i = 0; i < joints_.size(); ++i)
        if (!joints_[i].in_package)
            drive(i, {});
}

void DrivenJoints::drive(std::size_t joint, const JointMotor& motor) {
    joints_[joint].motor = motor;
    JointMotor weaker = motor;
    weaker.limit *= joints_[joint].stiffness;
    physics_.setMotor(body_, joint, weaker);
}

bool DrivenJoints::still() const {
    for (std::size_t i = 0; i < joints_.size(); ++i)
        if (std::abs(state(i).velocity) > still_rad_s)
            return false;
    return true;
}

std::vector<protocol::JointAngle> DrivenJoints::angles() const {
    std::vector<protocol::JointAngle> angles;
    for (std::size_t i = 0; i < joints_.size(); ++i)
        if (isFree(joints_[i]))
            angles.push_back({joints_[i].name, state(i).position});
    return angles;
}

Result<std::vector<std::size_t>> drivenLinks(const RobotModel& model) {
    std::vector<std::size_t> links;
    for (const std::string& joint : model.drive.joints) {
        const auto link =
            std::ranges::find_if(model.links, [&](const ModelLink& one) { return sameWord(one.joint, joint); });
        if (link == model.links.end())
            return failure("the drive's joint \"" + joint + "\" does not exist", "robot " + model.class_name,
                           "Name one of the model's joints");
        links.push_back(static_cast<std::size_t>(link - model.links.begin()));
    }
    return links;
}

void JointDrive::switchOff() {
    off_ = true;
    joints_.releaseAll();
    physics_.letSleep(body_, true);
}

void JointDrive::letSleep(bool allowed) {
    if (allowed != may_sleep_)
        physics_.letSleep(body_, allowed);
    may_sleep_ = allowed;
}

LegDrive::LegDrive(const RobotModel& model, Physics& physics, BodyId body, const std::vector<std::size_t>& joints)
    : JointDrive(model, physics, body)
    , reported_(joints) {
    for (const std::size_t joint : joints)
        joints_.hold(joint, 0.0);
}

bool LegDrive::obey(const protocol::Command& command) {
    if (off() || joints_.obey(command).empty())
        return false;
    still_for_ = Seconds{0.0};
    return true;
}

void LegDrive::beforeStep(Seconds dt) {
    if (off())
        return;
    still_for_ = joints_.still() ? still_for_ + dt : Seconds{0.0};
    letSleep(still_for_ > standing);
}

void LegDrive::addState(protocol::RobotState& state) const {
    for (const std::size_t joint : reported_)
        state.joints.push_back({joints_[joint].name, joints_.state(joint).position});
}

} // namespace usar::sim
