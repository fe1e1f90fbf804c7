#include "core/mission/commands/drive_merge.h"

#include <algorithm>

namespace usar::mission {

using namespace protocol;

namespace {

template <class T>
void keep(std::optional<T>& term, const std::optional<T>& old) {
    if (!term)
        term = old;
}

template <class Drive, class... Terms>
void keepEach(Drive& newer, const Drive& older, Terms Drive::*... terms) {
    (keep(newer.*terms, older.*terms), ...);
}

void keepTerms(DriveSwitches& newer, const DriveSwitches& older) {
    keepEach(newer, older, &DriveSwitches::light_on, &DriveSwitches::flip);
}
void keepTerms(SkidDrive& newer, const SkidDrive& older) {
    keepEach(newer, older, &SkidDrive::left_rad_s, &SkidDrive::right_rad_s);
}
void keepTerms(AckermannDrive& newer, const AckermannDrive& older) {
    using Drive = AckermannDrive;
    keepEach(newer, older, &Drive::speed_rad_s, &Drive::front_steer_rad, &Drive::rear_steer_rad);
}
void keepTerms(AerialDrive& newer, const AerialDrive& older) {
    using Drive = AerialDrive;
    keepEach(newer, older, &Drive::climb_m_s, &Drive::forward_m_s, &Drive::left_m_s, &Drive::yaw_rate_rad_s,
             &Drive::pitch_rad, &Drive::roll_rad);
}
void keepTerms(NauticDrive& newer, const NauticDrive& older) {
    using Drive = NauticDrive;
    keepEach(newer, older, &Drive::propeller_rad_s, &Drive::rudder_rad, &Drive::stern_plane_rad);
}
void keepTerms(OmniDrive& newer, const OmniDrive& older) {
    for (const WheelDrive& old : older.wheels) {
        const auto same = std::ranges::find(newer.wheels, old.wheel, &WheelDrive::wheel);
        if (same == newer.wheels.end()) {
            newer.wheels.push_back(old);
        } else {
            keep(same->spin_rad_s, old.spin_rad_s);
            keep(same->steer_rad, old.steer_rad);
        }
    }
}
void keepTerms(MultiDrive& newer, const MultiDrive& older) {
    for (const JointAngleTarget& old : older.joints) {
        if (std::ranges::find(newer.joints, old.joint, &JointAngleTarget::joint) == newer.joints.end())
            newer.joints.push_back(old);
    }
}
void keepTerms(JointDrive& newer, const JointDrive& older) {
    keep(newer.steer_rad, older.steer_rad);
    if (!newer.value && newer.order == older.order)
        newer.value = older.value;
    else if (newer.value && newer.order == older.order && newer.order >= JointOrder::RelativeAngle)
        newer.value = *newer.value + older.value.value_or(0.0);
}

template <class Drive>
DriveSwitches* switchesOf(Drive& drive) {
    if constexpr (std::is_same_v<Drive, DriveSwitches>)
        return &drive;
    else if constexpr (requires { drive.switches; })
        return &drive.switches;
    else
        return nullptr;
}
DriveSwitches switchesOf(const Command& command) {
    Command copy = command;
    const DriveSwitches* const found = std::visit([](auto& drive) { return switchesOf(drive); }, copy);
    return found ? *found : DriveSwitches{};
}

void forgetJoint(MultiDrive& drive, const Token& joint) {
    std::erase_if(drive.joints, [&joint](const JointAngleTarget& target) { return target.joint == joint; });
}

} // namespace

bool replaces(const Command& newer, const Command& older) {
    if (newer.index() != older.index())
        return false;
    const auto* const joint = std::get_if<JointDrive>(&newer);
    return !joint || joint->joint == std::get<JointDrive>(older).joint;
}

void keepAbsentTerms(Command& newer, const Command& older) {
    std::visit(
        [&older]<class Drive>(Drive& drive) {
            if constexpr (requires { keepTerms(drive, drive); }) {
                const Drive& old = std::get<Drive>(older);
                if constexpr (requires { drive.normalized; }) {
                    keepTerms(drive.switches, old.switches);
                    if (drive.normalized != old.normalized)
                        return;
                }
                keepTerms(drive, old);
            }
        },
        newer);
}

bool takeOutWhatIsOld(Command& older, const Command& newer) {
    const DriveSwitches said = switchesOf(newer);
    if (DriveSwitches* const old = std::visit([](auto& drive) { return switchesOf(drive); }, older)) {
        if (said.light_on)
            old->light_on.reset();
        if (said.flip)
            old->flip.reset();
    }
    if (older == Command(DriveSwitches{}))
        return false;
    if (auto* const joints = std::get_if<MultiDrive>(&older)) {
        if (const auto* const one = std::get_if<JointDrive>(&newer))
            forgetJoint(*joints, one->joint);
        return !joints->joints.empty();
    }
    const auto* const one = std::get_if<JointDrive>(&older);
    const auto* const joints = std::get_if<MultiDrive>(&newer);
    return !one || !joints ||
           std::ranges::find(joints->joints, one->joint, &JointAngleTarget::joint) == joints->joints.end();
}

} // namespace usar::mission
