#include "core/sim/physics/mass_matrix.h"

#include <Eigen/Cholesky>

#include "core/sim/physics/bullet_ground.h"

namespace usar::sim {

namespace {

Eigen::Matrix3d crossMatrix(const Vec3& v) {
    return Eigen::Matrix3d{{0.0, -v.z(), v.y()}, {v.z(), 0.0, -v.x()}, {-v.y(), v.x(), 0.0}};
}

/// Some bodies that are one rigid body for the moment. Moments are about the base's center, in the map frame.
struct Composite {
    double mass_kg = 0.0;
    Vec3 moment_kg_m = Vec3::Zero(); ///< mass times the center's place
    Eigen::Matrix3d inertia_kg_m2 = Eigen::Matrix3d::Zero();

    void add(const Composite& other) {
        mass_kg += other.mass_kg;
        moment_kg_m += other.moment_kg_m;
        inertia_kg_m2 += other.inertia_kg_m2;
    }
};

Composite bodyAt(const Vec3& center_m, double mass_kg, const btMatrix3x3& body_in_map, const btVector3& inertia_kg_m2) {
    const btMatrix3x3 about_center = body_in_map.scaled(inertia_kg_m2).timesTranspose(body_in_map);
    Eigen::Matrix3d inertia;
    for (int i = 0; i < 3; ++i)
        inertia.row(i) = fromBullet(about_center[i]);
    inertia += mass_kg * (center_m.squaredNorm() * Eigen::Matrix3d::Identity() - center_m * center_m.transpose());
    return {mass_kg, mass_kg * center_m, inertia};
}

/// An angular and a linear vector, about the base's center.
struct Spatial {
    Vec3 angular;
    Vec3 linear;
    double dot(const Spatial& other) const { return angular.dot(other.angular) + linear.dot(other.linear); }
};

/// The motion of what is behind a joint, at unit speed of the joint.
Spatial motionOf(const JointAxis& axis, const btVector3& base_m) {
    if (axis.slides)
        return {Vec3::Zero(), fromBullet(axis.along)};
    return {fromBullet(axis.along), fromBullet(axis.along.cross(base_m - axis.point_m))};
}

Spatial momentumOf(const Composite& bodies, const Spatial& motion) {
    return {bodies.inertia_kg_m2 * motion.angular + bodies.moment_kg_m.cross(motion.linear),
            bodies.mass_kg * motion.linear + motion.angular.cross(bodies.moment_kg_m)};
}

} // namespace

void addJointAxes(const btMultiBody& body, std::vector<JointAxis>& axes) {
    for (int i = 0; i < body.getNumLinks(); ++i) {
        const btMultibodyLink& link = body.getLink(i);
        const btMatrix3x3& link_in_map = link.m_cachedWorldTransform.getBasis();
        const bool slides = link.m_jointType == btMultibodyLink::ePrismatic;
        axes.push_back({link_in_map * (slides ? link.getAxisBottom(0) : link.getAxisTop(0)),
                        link.m_cachedWorldTransform.getOrigin() - link_in_map * link.m_dVector, slides});
    }
}

Eigen::MatrixXd inverseMassMatrix(const btMultiBody& body, std::span<const JointAxis> axes) {
    const btVector3& base_m = body.getBasePos();
    Composite whole =
        bodyAt(Vec3::Zero(), body.getBaseMass(), body.getBaseWorldTransform().getBasis(), body.getBaseInertia());
    std::vector<Composite> behind; // a joint: its link and all links that hang on it
    std::vector<Spatial> motions;
    for (int i = 0; i < body.getNumLinks(); ++i) {
        const btMultibodyLink& link = body.getLink(i);
        const btTransform& link_in_map = link.m_cachedWorldTransform;
        behind.push_back(bodyAt(fromBullet(link_in_map.getOrigin() - base_m), link.m_mass, link_in_map.getBasis(),
                                link.m_inertiaLocal));
        motions.push_back(motionOf(axes[static_cast<std::size_t>(i)], base_m));
    }
    Eigen::MatrixXd mass = Eigen::MatrixXd::Zero(6 + body.getNumDofs(), 6 + body.getNumDofs());
    // Only the lower triangle is filled in. A link comes after its parent.
    for (int i = body.getNumLinks() - 1; i >= 0; --i) {
        const auto joint = static_cast<std::size_t>(i);
        const Spatial momentum = momentumOf(behind[joint], motions[joint]);
        const int row = 6 + body.getLink(i).m_dofOffset;
        mass.block<1, 3>(row, 0) = momentum.angular.transpose();
        mass.block<1, 3>(row, 3) = momentum.linear.transpose();
        for (int on = i; on >= 0; on = body.getParent(on))
            mass(row, 6 + body.getLink(on).m_dofOffset) = momentum.dot(motions[static_cast<std::size_t>(on)]);
        const int parent = body.getParent(i);
        (parent < 0 ? whole : behind[static_cast<std::size_t>(parent)]).add(behind[joint]);
    }
    mass.topLeftCorner<3, 3>() = whole.inertia_kg_m2;
    mass.block<3, 3>(3, 0) = -crossMatrix(whole.moment_kg_m);
    mass.block<3, 3>(3, 3) = whole.mass_kg * Eigen::Matrix3d::Identity();
    return mass.llt().solve(Eigen::MatrixXd::Identity(mass.rows(), mass.cols()));
}

} // namespace usar::sim
