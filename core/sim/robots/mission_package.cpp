#include "core/sim/robots/mission_package.h"

#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/sim/robots/arm_solver.h"

namespace usar::sim {

namespace {

JointMotor::Mode modeOf(protocol::LinkOrder order) {
    using enum JointMotor::Mode;
    return order == protocol::LinkOrder::Speed ? Velocity : order == protocol::LinkOrder::Torque ? Torque : Position;
}

} // namespace

MissionPackage::MissionPackage(const PackageModel& model, RobotBody& body) : model_(model), body_(body) {
    for (const std::string& joint : model_.joints)
        links_.push_back(static_cast<std::size_t>(body.model().linkOnJoint(joint).value_or(0)));
    for (std::size_t i = 0; i < links_.size(); ++i)
        move(static_cast<int>(i) + 1, 0.0, protocol::LinkOrder::Angle);
}

const ModelLink& MissionPackage::link(std::size_t index) const {
    return body_.model().links[links_[index]];
}

bool MissionPackage::obey(const protocol::Command& command) {
    if (const auto* const drive = std::get_if<protocol::PackageDrive>(&command)) {
        if (!sameWord(drive->package, name()))
            return false;
        for (const protocol::LinkTarget& target : drive->links)
            move(target.link, target.value, target.order);
        return true;
    }
    if (const auto* const pose = std::get_if<protocol::PackagePose>(&command)) {
        if (!sameWord(pose->package, name()))
            return false;
        reach(*pose);
        return true;
    }
    if (const auto* const turn = std::get_if<protocol::PackageRotation>(&command)) {
        if (!sameWord(turn->package, name()))
            return false;
        move(1, turn->pan_rad, turn->order);
        move(2, turn->tilt_rad, turn->order);
        return true;
    }
    const auto* const actuator = std::get_if<protocol::ActuatorDrive>(&command);
    if (!actuator || !sameWord(actuator->actuator, name()))
        return false;
    for (const protocol::LinkValue& target : actuator->links)
        move(target.link, target.value, protocol::LinkOrder::Angle);
    return true;
}

void MissionPackage::reach(const protocol::PackagePose& wanted) {
    std::vector<double> all;
    for (std::size_t i = 0; i < body_.model().links.size(); ++i)
        all.push_back(body_.joint(static_cast<int>(i)).position);
    TipTarget target{wanted.tip_in_base_m, {}};
    if (wanted.tip_angles_rad)
        target.rotation_in_base =
            Pose{{}, wanted.tip_angles_rad->x(), wanted.tip_angles_rad->y(), wanted.tip_angles_rad->z()}.rotation();
    const ArmSolution found = ArmSolver(body_.model(), model_).solve(target, all);
    if (!found.reached()) {
        trouble_ = name() + " cannot reach that pose: it comes no nearer than " + fixed(found.off_m, 3) + " m and " +
                   fixed(found.off_rad, 3) + " rad; it stays where it is";
        return;
    }
    trouble_.reset();
    for (std::size_t i = 0; i < links_.size(); ++i)
        move(static_cast<int>(i) + 1, found.positions[i], protocol::LinkOrder::Angle);
}

/// Ignores a link that the package does not have, as servers do.
void MissionPackage::move(int number, double value, protocol::LinkOrder order) {
    if (number < 1 || static_cast<std::size_t>(number) > links_.size())
        return;
    const auto index = static_cast<std::size_t>(number) - 1;
    body_.physics().setMotor(body_.id(), links_[index],
                             {modeOf(order), value, link(index).torque_limit, link(index).speed_limit});
}

void MissionPackage::switchOff() {
    for (const std::size_t link : links_)
        body_.physics().setMotor(body_.id(), link, {});
}

protocol::PackageState MissionPackage::state(Seconds now) const {
    protocol::PackageState state{now, name(), {}};
    for (std::size_t i = 0; i < links_.size(); ++i)
        state.links.push_back(
            {static_cast<long long>(i) + 1, body_.joint(static_cast<int>(links_[i])).position, -link(i).torque_limit});
    return state;
}

std::vector<protocol::MountedItem> MissionPackage::geometry() const {
    std::vector<protocol::MountedItem> items;
    std::string mount = "HARD";
    for (std::size_t i = 0; i < links_.size(); ++i) {
        const LinkDescription& link = body_.model().body.links[links_[i]];
        const Vec3 holder_center_m =
            link.parent < 0 ? body_.model().center_of_mass_in_base_m
                            : body_.model().links[static_cast<std::size_t>(link.parent)].center_of_mass_in_link_m;
        Pose pivot_in_holder = link.link_in_parent;
        pivot_in_holder.position_m = link.link_in_parent * link.pivot_in_link_m + holder_center_m;
        std::string name = model_.name + "_Link" + std::to_string(i + 1);
        items.push_back({name, pivot_in_holder, mount, {}});
        mount = std::move(name);
        if (i + 1 == links_.size() && model_.tip_in_last_link_m)
            items.back().tip_in_item_m =
                *model_.tip_in_last_link_m - link.pivot_in_link_m - this->link(i).center_of_mass_in_link_m;
    }
    return items;
}

std::vector<protocol::Setting> MissionPackage::settings() const {
    std::vector<protocol::Setting> settings;
    for (std::size_t i = 0; i < links_.size(); ++i) {
        const LinkDescription& joint = body_.model().body.links[links_[i]];
        settings.insert(settings.end(),
                        {{"Link", std::to_string(i + 1), static_cast<double>(i + 1)},
                         {"JointType", joint.kind == JointKind::Revolute ? "Revolute" : "Prismatic", {}},
                         {"MaxSpeed", "", link(i).speed_limit},
                         {"MaxTorque", "", link(i).torque_limit},
                         {"MinRange", "", joint.lower},
                         {"MaxRange", "", joint.upper}});
    }
    return settings;
}

} // namespace usar::sim
