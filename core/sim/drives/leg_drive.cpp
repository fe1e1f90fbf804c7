#include "core/sim/drives/leg_drive.h"

#include "core/sim/drives/wheeled_drive.h"

namespace usar::sim {

namespace {

constexpr Seconds standing{1.0};

} // namespace

Result<std::unique_ptr<Drive>> LegDrive::make(const RobotModel& model, Physics& physics, BodyId body) {
    const auto joints = linksOn(model, model.drive.joints);
    if (!joints)
        return tl::unexpected(joints.error());
    return std::unique_ptr<Drive>(new LegDrive(model, physics, body, *joints));
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

void LegDrive::addTo(protocol::RobotState& state) const {
    for (const std::size_t joint : reported_)
        state.joints.push_back({joints_.name(joint), joints_.state(joint).position});
}

} // namespace usar::sim
