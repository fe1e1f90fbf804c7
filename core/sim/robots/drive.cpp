#include "core/sim/robots/drive.h"

#include "core/sim/drives/ackermann_drive.h"
#include "core/sim/drives/driven_joints.h"
#include "core/sim/drives/nautic_drive.h"
#include "core/sim/drives/rotor_drive.h"
#include "core/sim/drives/wheeled_drive.h"

namespace usar::sim {

Result<std::unique_ptr<Drive>> makeDrive(const RobotModel& model, Physics& physics, BodyId body, const World& world,
                                         const DriveBirth& birth) {
    if (model.drive.kind == "rotors")
        return std::make_unique<RotorDrive>(physics, body, birth, airRobotParametersOf(model));
    if (model.drive.kind == "nautic")
        return std::make_unique<NauticDrive>(model, physics, body, world);
    if (model.drive.kind == "skid")
        return SkidDrive::make(model, physics, body);
    if (model.drive.kind == "ackermann")
        return AckermannDrive::make(model, physics, body);
    if (model.drive.kind == "legs")
        return LegDrive::make(model, physics, body);
    return failure("there is no drive of the kind \"" + model.drive.kind + "\"", "robot " + model.class_name,
                   "Known are rotors, skid, ackermann, nautic and legs");
}

} // namespace usar::sim
