#include "core/sim/robots/drive.h"

#include "core/sim/drives/ackermann_drive.h"
#include "core/sim/drives/driven_joints.h"
#include "core/sim/drives/nautic_drive.h"
#include "core/sim/drives/omni_drive.h"
#include "core/sim/drives/rotor_drive.h"
#include "core/sim/drives/wheeled_drive.h"

namespace usar::sim {

Result<std::unique_ptr<Drive>> makeDrive(const RobotModel& model, Physics& physics, BodyId body, const World& world,
                                         bool near_ground) {
    const DriveModel& drive = model.drive;
    const auto joints = drivenLinks(model);
    if (!joints)
        return tl::unexpected(joints.error());
    if (drive.kind == "rotors")
        return std::make_unique<RotorDrive>(
            physics, body, near_ground,
            AirRobotParameters{drive.numbers, model.mass_kg(), model.body.base.inertia_kg_m2});
    if (drive.kind == "nautic")
        return std::make_unique<NauticDrive>(model, physics, body, world);
    if (drive.kind == "skid")
        return SkidDrive::make(model, physics, body, *joints);
    if (drive.kind == "ackermann")
        return AckermannDrive::make(model, physics, body, *joints);
    if (drive.kind == "omni")
        return OmniDrive::make(model, physics, body, *joints);
    if (drive.kind == "legs" || drive.kind == "none")
        return std::make_unique<LegDrive>(model, physics, body, *joints);
    return failure("there is no drive of the kind \"" + drive.kind + "\"", "robot " + model.class_name,
                   "Known are rotors, skid, ackermann, omni, nautic, legs and none");
}

} // namespace usar::sim
