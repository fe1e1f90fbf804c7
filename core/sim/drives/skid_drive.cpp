#include "core/sim/drives/skid_drive.h"

#include "core/sim/drives/drive_term.h"

namespace usar::sim {

Result<std::unique_ptr<Drive>> SkidDrive::make(const RobotModel& model, Physics& physics, BodyId body) {
    const auto wheels = linksOn(model, model.drive.joints);
    if (!wheels)
        return tl::unexpected(wheels.error());
    if (wheels->empty() || wheels->size() % 2 != 0)
        return failure("a skid drive has " + std::to_string(wheels->size()) + " joints", "robot " + model.class_name,
                       "Name the left wheels' joints and then as many right ones");
    return std::unique_ptr<Drive>(new SkidDrive(model, physics, body, *wheels));
}

bool SkidDrive::obey(const protocol::Command& command) {
    const auto* drive = std::get_if<protocol::SkidDrive>(&command);
    if (!drive)
        return obeyJoint(command);
    wheels_.takeBack();
    const std::size_t half = wheels_.count() / 2;
    for (std::size_t i = 0; i < wheels_.count(); ++i)
        if (const std::optional<double>& side = i < half ? drive->left_rad_s : drive->right_rad_s)
            wheels_.want(i, limited(*side, wheels_.largestSpin(), drive->normalized));
    return true;
}

void SkidDrive::addTo(protocol::RobotState& state) const {
    WheeledDrive::addTo(state);
    state.joints = joints_.angles();
}

} // namespace usar::sim
