#include "tests/sim/driven_robot.h"

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <map>

#include "core/sim/robots/drive.h"
#include "core/sim/robots/robot_reader.h"

namespace usar::sim {

namespace {

template <class T>
T orExit(Result<T> result) {
    if (!result) {
        std::cerr << result.error().text() << '\n';
        std::exit(1);
    }
    return std::move(*result);
}

/// Files are read once a program: that costs more than most runs.
const RobotModel& modelOf(const std::string& file) {
    static std::map<std::string, RobotModel> models;
    const auto known = models.find(file);
    return known != models.end() ? known->second : models.emplace(file, orExit(readRobot(file))).first->second;
}

/// How far a part goes down from its middle.
double reach(const BodyPart& part) {
    if (const auto* box = std::get_if<BoxShape>(&part.shape)) {
        const Eigen::Matrix3d rotation = part.part_in_body.rotation().toRotationMatrix();
        return (rotation.row(2).cwiseAbs() * box->size_m)(0) / 2.0;
    }
    if (const auto* ball = std::get_if<SphereShape>(&part.shape))
        return ball->radius_m;
    const double up = std::abs((part.part_in_body.rotation() * Vec3::UnitZ()).z());
    if (const auto* capsule = std::get_if<CapsuleShape>(&part.shape))
        return capsule->radius_m + up * capsule->height_m / 2.0;
    const auto& cylinder = std::get<CylinderShape>(part.shape);
    return up * cylinder.height_m / 2.0 + std::sqrt(1.0 - up * up) * cylinder.radius_m;
}

/// Just so high that nothing is in the ground.
Pose standing(const RobotModel& model, const World& world, double x_m, double y_m, double yaw_rad) {
    double lowest_m = 0.0;
    for (const BodyPart& part : model.whole().parts)
        lowest_m = std::min(lowest_m, part.part_in_body.position_m.z() - reach(part));
    const double ground_m = world.terrain.height_m({x_m, y_m});
    return Pose{{x_m, y_m, ground_m - lowest_m + 0.002}, 0.0, 0.0, yaw_rad};
}

} // namespace

DrivenRobot::DrivenRobot(World world_, const std::string& robots, const std::string& class_name, double x_m, double y_m,
                         double yaw_rad)
    : world(std::move(world_))
    , physics(makePhysics(world))
    , model(modelOf(robots + "/" + class_name + ".sdf"))
    , body(*physics, model, standing(model, world, x_m, y_m, yaw_rad))
    , drive(orExit(makeDrive(model, *physics, body.id(), world, false))) {}

void DrivenRobot::run(Seconds duration, const std::function<void()>& each) {
    for (long i = std::lround(duration / physics_dt); i > 0; --i) {
        drive->beforeStep(physics_dt);
        physics->step(physics_dt);
        drive->afterStep(physics_dt);
        body.afterStep();
        if (each)
            each();
    }
}

} // namespace usar::sim
