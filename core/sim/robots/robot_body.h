// A robot's body in the physics, in terms of the frames of its file: base, links and joints.
#pragma once

#include <vector>

#include "core/sim/physics/physics.h"
#include "core/sim/robots/robot_model.h"

namespace usar::sim {

/// Adds the body to the physics and removes it when destroyed. `physics` and `model` must outlive it.
class RobotBody {
public:
    RobotBody(Physics& physics, const RobotModel& model, const Pose& base_in_map);
    ~RobotBody();
    RobotBody(const RobotBody&) = delete;
    RobotBody& operator=(const RobotBody&) = delete;

    const RobotModel& model() const { return model_; }
    Physics& physics() const { return physics_; }
    BodyId id() const { return id_; }

    /// Pose of the base's frame.
    Pose base_in_map() const;
    /// Velocity of the base's center of mass.
    Vec3 velocity_in_map_m_s() const { return physics_.state(id_).velocity_m_s; }
    /// Angular velocity of the base.
    Vec3 rate_in_map_rad_s() const { return physics_.state(id_).rate_rad_s; }
    /// Pose of a link's frame, or of the base's if `link` is -1.
    Eigen::Isometry3d link_in_map(int link) const;
    /// State of the joint that a link hangs on; the base has none.
    JointState joint(int link) const { return physics_.joint(id_, static_cast<std::size_t>(link)); }

    /// Called after each physics step: remembers the touched links and adds up the path.
    void afterStep();
    /// True if the link, or the base if it is -1, was touched since the last call of `forgetTouches`.
    bool touched(int link) const { return touched_[static_cast<std::size_t>(link + 1)]; }
    void forgetTouches();
    /// Length of the path so far.
    double distance_m() const { return distance_m_; }

private:
    Physics& physics_;
    const RobotModel& model_;
    BodyId id_;
    std::vector<bool> touched_; ///< base first
    Vec3 last_position_m_;
    double distance_m_ = 0.0;
};

} // namespace usar::sim
