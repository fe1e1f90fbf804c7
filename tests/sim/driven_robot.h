// A robot of resources/robots with its drive and nothing else, for tests of wheels and legs.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "core/sim/physics/physics.h"
#include "core/sim/robots/drive.h"
#include "core/sim/robots/robot_body.h"
#include "tests/sim/tiny_worlds.h"

namespace usar::sim {

struct DrivenRobot {
    /// `class_name` is that of a file in `robots`; its lowest point starts just above the ground at (x, y).
    DrivenRobot(World world_, const std::string& robots, const std::string& class_name, double x_m, double y_m,
                double yaw_rad = 0.0);

    /// Runs the robot; `each` is called after every physics step.
    void run(Seconds duration, const std::function<void()>& each = {});
    Pose pose() const { return body.base_in_map(); }
    Vec3 position_m() const { return pose().position_m; }
    double speed_m_s() const { return body.velocity_in_map_m_s().norm(); }
    JointState joint(const std::string& name) const { return body.joint(model.linkOnJoint(name).value()); }

    World world;
    std::unique_ptr<Physics> physics;
    RobotModel model;
    RobotBody body;
    std::unique_ptr<Drive> drive;
};

} // namespace usar::sim
