// The mass matrix of an articulated body. Internal to the physics.
#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include <BulletDynamics/Featherstone/btMultiBody.h>

namespace usar::sim {

/// A joint's axis in the map frame, and a point on it.
struct JointAxis {
    btVector3 along; ///< unit vector
    btVector3 point_m;
    bool slides = false; ///< otherwise it turns
};

/// Appends the axes of all joints, in the order of the links.
void addJointAxes(const btMultiBody& body, std::vector<JointAxis>& axes);

/// The inverse of the matrix that maps a body's velocities to its momenta. Both are those of Bullet: first the base's
/// angular velocity (rad/s) and its velocity (m/s), in the map frame, then the joints' (rad/s or m/s). The mass matrix
/// is computed by composite rigid bodies (R. Featherstone, *Rigid Body Dynamics Algorithms*, 2008, section 6.2). Each
/// joint must have one degree of freedom. `axes` are those that addJointAxes() adds.
Eigen::MatrixXd inverseMassMatrix(const btMultiBody& body, std::span<const JointAxis> axes);

} // namespace usar::sim
