// Inverse kinematics of a mission package: the joint positions that bring its last link to a pose.
#pragma once

#include <optional>
#include <vector>

#include "core/base/geometry.h"
#include "core/sim/robots/robot_model.h"

namespace usar::sim {

/// The pose that the tip of a package's last link has to reach, in the frame of the robot's base. Without an
/// orientation only the position counts, so that three joints suffice.
struct TipTarget {
    Vec3 position_in_base_m = Vec3::Zero();
    std::optional<Eigen::Quaterniond> rotation_in_base{};
};

/// The best that was found for a target.
struct ArmSolution {
    std::vector<double> positions{}; ///< rad or m, one for each joint of the package
    double off_m = 0.0;              ///< distance of the tip from the target
    double off_rad = 0.0;            ///< angle from the wanted orientation; 0 if none was wanted
    bool reached() const { return off_m < 1e-3 && off_rad < 1e-2; }
};

/// Damped least squares after Levenberg and Marquardt, from where the arm is and then from other postures, within the
/// joints' limits. Joints on the way that do not belong to the package stay where they are. It knows no obstacles.
class ArmSolver {
public:
    /// `model` must outlive it, and have the package's joints.
    ArmSolver(const RobotModel& model, const PackageModel& package);

    /// Pose of the tip in the base's frame. `all` has the positions of all joints of the robot, by link.
    Eigen::Isometry3d tipInBase(const std::vector<double>& all) const;
    ArmSolution solve(const TipTarget& target, const std::vector<double>& all) const;

private:
    /// Position of the tip relative to the target, and the turn that is missing, both in the base's frame. The turn is
    /// weighted by a length, so that both are in meters.
    Eigen::VectorXd errorAt(const TipTarget& target, const std::vector<double>& all) const;
    Eigen::MatrixXd slopesAt(const TipTarget& target, const std::vector<double>& all) const;
    Eigen::Isometry3d linkInBase(int link, const std::vector<double>& all) const;
    void descend(const TipTarget& target, std::vector<double>& all) const;
    void limit(std::vector<double>& all) const;
    ArmSolution solutionAt(const TipTarget& target, const std::vector<double>& all) const;

    const RobotModel& model_;
    std::vector<std::size_t> links_; ///< on the package's joints
    Vec3 tip_in_body_m_;             ///< in the frame of the last link's center of mass
};

} // namespace usar::sim
