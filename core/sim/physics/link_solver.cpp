#include "core/sim/physics/link_solver.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Core>

#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>

namespace usar::sim {

namespace {

constexpr int most_sweeps = 20;
constexpr double settled = 1e-4; ///< m/s or rad/s: a sweep that changes less is the last one
constexpr double least_mobility = 1e-12;
constexpr double same_joint = 1e-5; ///< rad or m
constexpr int most_turned = 64;     ///< size of the largest matrix that is kept

const btMultiBodyLinkCollider* linkOf(const btCollisionObject& object) {
    return btMultiBodyLinkCollider::upcast(&object);
}

/// Speed of a kinematic body's surface; zero for what is fixed.
btVector3 surfaceVelocity(const btCollisionObject& object, const btVector3& point_m) {
    const btRigidBody* const rigid = btRigidBody::upcast(&object);
    return rigid ? rigid->getVelocityInLocalPoint(point_m - rigid->getWorldTransform().getOrigin())
                 : btVector3(0.0, 0.0, 0.0);
}

using Reals = Eigen::Map<Eigen::VectorXd>;
using ConstReals = Eigen::Map<const Eigen::VectorXd>;

double dot(const double* a, const double* b, int size) {
    return ConstReals(a, size).dot(ConstReals(b, size));
}

void addTimes(double* sum, const double* what, double factor, int size) {
    Reals(sum, size) += factor * ConstReals(what, size);
}

/// True if a joint that moves masses is not where it was.
bool hasMoved(const btMultiBody& body, const JointedBody& jointed, std::span<const double> joints) {
    for (int i = 0; i < body.getNumLinks(); ++i)
        if (jointed.movesMass(i) && std::abs(body.getJointPos(i) - joints[static_cast<std::size_t>(i)]) > same_joint)
            return true;
    return false;
}

/// Turns the base's rows and columns of a matrix, first those of its rotation, then those of its motion.
void turn(double* matrix, int size, const btMatrix3x3& rotation) {
    using Rows = Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::ColMajor, 3, most_turned>;
    const Eigen::Matrix3d by{{rotation[0][0], rotation[0][1], rotation[0][2]},
                             {rotation[1][0], rotation[1][1], rotation[1][2]},
                             {rotation[2][0], rotation[2][1], rotation[2][2]}};
    Eigen::Map<Eigen::MatrixXd> whole(matrix, size, size);
    for (const int first : {0, 3}) {
        const Rows rows = by * whole.middleRows<3>(first);
        whole.middleRows<3>(first) = rows;
        const Rows columns = by * whole.middleCols<3>(first).transpose();
        whole.middleCols<3>(first) = columns.transpose();
    }
}

} // namespace

JointedBody* jointedBodyOf(const btCollisionObject& object) {
    const btMultiBodyLinkCollider* const link = linkOf(object);
    return link && link->m_link < 0 ? static_cast<JointedBody*>(link->m_multiBody->getUserPointer()) : nullptr;
}

bool isOnWheels(const btCollisionObject& object) {
    const btMultiBodyLinkCollider* const link = linkOf(object);
    return link && static_cast<const JointedBody*>(link->m_multiBody->getUserPointer())->onWheels();
}

bool LinkSolver::canSolve(std::span<btCollisionObject* const> bodies) {
    return std::ranges::all_of(bodies, [](const btCollisionObject* body) { return linkOf(*body); });
}

void LinkSolver::solve(std::span<btCollisionObject* const> bodies, std::span<btPersistentManifold* const> manifolds,
                       const btContactSolverInfo& info) {
    members_.clear();
    axes_.clear();
    joints_.clear();
    normals_.clear();
    frictions_.clear();
    numbers_.clear();
    for (btCollisionObject* const object : bodies)
        if (linkOf(*object)->m_link < 0)
            addMember(*linkOf(*object)->m_multiBody);
    for (std::size_t i = 0; i < members_.size(); ++i)
        addJoints(static_cast<int>(i), info.m_timeStep);
    for (btPersistentManifold* const manifold : manifolds)
        addContacts(*manifold, info);
    begin(std::ranges::all_of(bodies, [](const btCollisionObject* body) { return isOnWheels(*body); }));
    for (int i = 0; i < most_sweeps && sweep(i % 2 == 0) > settled; ++i) {
    }
    for (const std::vector<Row>* const rows : {&joints_, &normals_, &frictions_})
        for (const Row& row : *rows)
            *row.kept = row.impulse;
    for (const Member& member : members_) {
        member.body->applyDeltaVeeMultiDof(&numbers_[member.change], 1.0);
        member.body->setCompanionId(-1);
    }
}

void LinkSolver::addMember(btMultiBody& body) {
    const int size = body.getNumDofs() + 6;
    const auto count = static_cast<std::size_t>(size);
    const Member member{&body, size, numbers_.size(), numbers_.size() + count * count, axes_.size()};
    addJointAxes(body, axes_);
    numbers_.resize(numbers_.size() + count * count + count, 0.0);
    invert(member);
    body.setCompanionId(static_cast<int>(members_.size()));
    members_.push_back(member);
}

void LinkSolver::invert(const Member& member) {
    btMultiBody& body = *member.body;
    auto* const jointed = static_cast<JointedBody*>(body.getUserPointer());
    KeptInverse& kept = jointed->keptInverse();
    const auto count = static_cast<std::size_t>(member.size);
    double* const inverse = &numbers_[member.inverse];
    const btMatrix3x3 base_in_map = btMatrix3x3(body.getWorldToBaseRot()).transpose();
    if (!kept.in_base.empty() && !hasMoved(body, *jointed, kept.joints)) {
        std::ranges::copy(kept.in_base, inverse);
        return turn(inverse, member.size, base_in_map);
    }
    Eigen::Map<Eigen::MatrixXd>(inverse, member.size, member.size) =
        inverseMassMatrix(body, std::span(axes_).subspan(member.axes));
    if (member.size > most_turned)
        return;
    kept.in_base.assign(inverse, inverse + count * count);
    turn(kept.in_base.data(), member.size, base_in_map.transpose());
    kept.joints.clear();
    for (int i = 0; i < body.getNumLinks(); ++i)
        kept.joints.push_back(body.getJointPos(i));
}

void LinkSolver::addJoints(int index, double dt_s) {
    const Member& member = members_[static_cast<std::size_t>(index)];
    auto* const jointed = static_cast<JointedBody*>(member.body->getUserPointer());
    for (const JointRow& wanted : jointed->jointRows(dt_s)) {
        Row row;
        row.a.member = index;
        const auto count = static_cast<std::size_t>(member.size);
        row.a.response = member.inverse + static_cast<std::size_t>(wanted.dof) * count;
        row.dof = wanted.dof;
        row.mobility = numbers_[row.a.response + static_cast<std::size_t>(wanted.dof)];
        row.wanted = wanted.speed - member.body->getVelocityVector()[wanted.dof];
        row.low = wanted.low_n_s;
        row.high = wanted.high_n_s;
        row.kept = wanted.impulse;
        joints_.push_back(row);
    }
}

void LinkSolver::addContacts(btPersistentManifold& manifold, const btContactSolverInfo& info) {
    for (int i = 0; i < manifold.getNumContacts(); ++i) {
        btManifoldPoint& point = manifold.getContactPoint(i);
        if (point.getDistance() <= manifold.getContactProcessingThreshold())
            addContact(manifold, point, info);
        else
            point.m_appliedImpulse = 0.0;
    }
}

void LinkSolver::addContact(const btPersistentManifold& manifold, btManifoldPoint& point,
                            const btContactSolverInfo& info) {
    const btVector3& normal = point.m_normalWorldOnB;
    const btVector3 none(0.0, 0.0, 0.0);
    double speed = 0.0;
    Row& press = addRow(normals_, manifold, point, normal, none, speed);
    const double gap_m = point.getDistance() + info.m_linearSlop;
    const bool bounces = std::abs(speed) >= info.m_restitutionVelocityThreshold;
    const double leaving = bounces ? std::max(0.0, -speed * point.m_combinedRestitution) : 0.0;
    press.wanted = leaving - speed - gap_m / info.m_timeStep * (gap_m > 0.0 ? 1.0 : info.m_erp2);
    press.high = 1e10;
    press.kept = &point.m_appliedImpulse;
    const int pressing = static_cast<int>(normals_.size()) - 1;
    btPlaneSpace1(normal, point.m_lateralFrictionDir1, point.m_lateralFrictionDir2);
    const auto rub = [&](const btVector3& force, const btVector3& torque, double share, btScalar* kept) {
        Row& row = addRow(frictions_, manifold, point, force, torque, speed);
        row.wanted = -speed;
        row.rubbing = share;
        row.normal = pressing;
        row.kept = kept;
    };
    rub(point.m_lateralFrictionDir1, none, point.m_combinedFriction, &point.m_appliedImpulseLateral1);
    rub(point.m_lateralFrictionDir2, none, point.m_combinedFriction, &point.m_appliedImpulseLateral2);
    if (point.m_combinedRollingFriction > 0.0) {
        rub(none, point.m_lateralFrictionDir1, point.m_combinedRollingFriction, &point.m_contactMotion1);
        rub(none, point.m_lateralFrictionDir2, point.m_combinedRollingFriction, &point.m_contactMotion2);
    }
}

LinkSolver::Row& LinkSolver::addRow(std::vector<Row>& rows, const btPersistentManifold& manifold,
                                    const btManifoldPoint& point, const btVector3& force, const btVector3& torque,
                                    double& speed) {
    speed = 0.0;
    Row row;
    row.a = sideOf(*manifold.getBody0(), {point.getPositionWorldOnA(), force, torque}, speed, row.mobility);
    row.b = sideOf(*manifold.getBody1(), {point.getPositionWorldOnB(), -force, -torque}, speed, row.mobility);
    return rows.emplace_back(row);
}

LinkSolver::Side LinkSolver::sideOf(const btCollisionObject& object, const Push& push, double& speed,
                                    double& mobility) {
    const btMultiBodyLinkCollider* const link = linkOf(object);
    if (!link) {
        speed += surfaceVelocity(object, push.point_m).dot(push.force);
        return {};
    }
    Side side{.member = link->m_multiBody->getCompanionId()};
    const Member& member = members_[static_cast<std::size_t>(side.member)];
    const auto count = static_cast<std::size_t>(member.size);
    side.jacobian = numbers_.size();
    side.response = numbers_.size() + count;
    numbers_.resize(numbers_.size() + 2 * count, 0.0);
    double* const jacobian = &numbers_[side.jacobian];
    double* const response = &numbers_[side.response];
    fillJacobian(member, link->m_link, push, jacobian);
    for (std::size_t i = 0; i < count; ++i)
        if (jacobian[i] != 0.0)
            addTimes(response, &numbers_[member.inverse + i * count], jacobian[i], member.size);
    speed += dot(jacobian, member.body->getVelocityVector(), member.size);
    mobility += dot(jacobian, response, member.size);
    return side;
}

// The base's angular velocity comes first, then its linear velocity, then the joints; all in the map frame.
void LinkSolver::fillJacobian(const Member& member, int link, const Push& push, double* jacobian) const {
    const btVector3 turning = (push.point_m - member.body->getBasePos()).cross(push.force) + push.torque;
    for (int i = 0; i < 3; ++i) {
        jacobian[i] = turning[i];
        jacobian[3 + i] = push.force[i];
    }
    for (; link >= 0; link = member.body->getParent(link)) {
        const JointAxis& axis = axes_[member.axes + static_cast<std::size_t>(link)];
        const btVector3 moved =
            axis.slides ? push.force : (push.point_m - axis.point_m).cross(push.force) + push.torque;
        jacobian[6 + member.body->getLink(link).m_dofOffset] = axis.along.dot(moved);
    }
}

void LinkSolver::begin(bool warm) {
    for (std::vector<Row>* const rows : {&joints_, &normals_, &frictions_})
        for (Row& row : *rows) {
            if (row.normal >= 0)
                row.high = row.rubbing * normals_[static_cast<std::size_t>(row.normal)].impulse;
            row.low = row.normal >= 0 ? -row.high : row.low;
            row.stiffness = row.mobility < least_mobility ? 0.0 : 1.0 / row.mobility;
            row.impulse = warm ? std::clamp(static_cast<double>(*row.kept), row.low, row.high) : 0.0;
            if (row.impulse == 0.0)
                continue;
            for (const Side& side : {row.a, row.b})
                if (side.member >= 0) {
                    const Member& member = members_[static_cast<std::size_t>(side.member)];
                    addTimes(&numbers_[member.change], &numbers_[side.response], row.impulse, member.size);
                }
        }
}

double LinkSolver::sweep(bool backward) {
    double most = 0.0;
    for (std::size_t i = 0; i < joints_.size(); ++i)
        most = std::max(most, resolve(joints_[backward ? joints_.size() - 1 - i : i]));
    for (Row& row : normals_)
        most = std::max(most, resolve(row));
    for (Row& row : frictions_) {
        row.high = row.rubbing * normals_[static_cast<std::size_t>(row.normal)].impulse;
        row.low = -row.high;
        most = std::max(most, resolve(row));
    }
    return most;
}

double LinkSolver::resolve(Row& row) {
    if (row.high == row.low && row.impulse == row.low)
        return 0.0; // Nothing presses, so nothing rubs.
    const Member* const a = row.a.member < 0 ? nullptr : &members_[static_cast<std::size_t>(row.a.member)];
    const Member* const b = row.b.member < 0 ? nullptr : &members_[static_cast<std::size_t>(row.b.member)];
    double missing = row.wanted;
    if (row.dof >= 0)
        missing -= numbers_[a->change + static_cast<std::size_t>(row.dof)];
    else if (a)
        missing -= dot(&numbers_[row.a.jacobian], &numbers_[a->change], a->size);
    if (b)
        missing -= dot(&numbers_[row.b.jacobian], &numbers_[b->change], b->size);
    const double before = row.impulse;
    row.impulse = std::clamp(before + missing * row.stiffness, row.low, row.high);
    const double added = row.impulse - before;
    if (added == 0.0)
        return 0.0;
    if (a)
        addTimes(&numbers_[a->change], &numbers_[row.a.response], added, a->size);
    if (b)
        addTimes(&numbers_[b->change], &numbers_[row.b.response], added, b->size);
    return std::abs(added) * row.mobility;
}

} // namespace usar::sim
