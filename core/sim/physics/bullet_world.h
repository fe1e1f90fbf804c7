// Bullet's dynamics world for articulated bodies, which costs nothing while there are none. Internal to the physics.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include <BulletDynamics/Featherstone/btMultiBodyConstraintSolver.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>
#include <btBulletDynamicsCommon.h>

#include "core/sim/physics/link_solver.h"

namespace usar::sim {

/// Solver for contacts and joints. One direction of friction suffices for rigid bodies: it halves the cost and lets a
/// body come to rest. Links of articulated bodies have no direction of sliding and need two, but Bullet has one switch
/// for all contacts. Links also need more iterations, because Bullet does not remember their impulses from the last
/// step.
class BulletSolver : public btMultiBodyConstraintSolver {
public:
    /// Leaves groups of robots to a LinkSolver. Where a robot touches a thing, there are 60 iterations, whatever `info`
    /// says: with 20, a crate slips out of a gripper by 2 to 3 mm/s (`tst_gripper`).
    void solveMultiBodyGroup(btCollisionObject** bodies, int body_count, btPersistentManifold** manifolds,
                             int manifold_count, btTypedConstraint** constraints, int constraint_count,
                             btMultiBodyConstraint** joints, int joint_count, const btContactSolverInfo& info,
                             btIDebugDraw* drawer, btDispatcher* dispatcher) override {
        const std::span members(bodies, static_cast<std::size_t>(body_count));
        if (LinkSolver::canSolve(members)) {
            links_.solve(members, {manifolds, static_cast<std::size_t>(manifold_count)}, info);
            return;
        }
        joints_.assign(joints, joints + joint_count);
        for (const btCollisionObject* const body : members)
            if (JointedBody* const jointed = jointedBodyOf(*body)) {
                const auto own = jointed->ownConstraints(info.m_timeStep);
                joints_.insert(joints_.end(), own.begin(), own.end());
            }
        btContactSolverInfo thorough = info;
        thorough.m_numIterations = 60;
        btMultiBodyConstraintSolver::solveMultiBodyGroup(
            bodies, body_count, manifolds, manifold_count, constraints, constraint_count, joints_.data(),
            static_cast<int>(joints_.size()), thorough, drawer, dispatcher);
    }

protected:
    /// Chooses one or two directions of friction for each contact by what it touches.
    void convertContacts(btPersistentManifold** manifolds, int count, const btContactSolverInfo& info) override {
        btContactSolverInfo both_directions = info;
        both_directions.m_solverMode |= SOLVER_USE_2_FRICTION_DIRECTIONS;
        for (int i = 0; i < count; ++i) {
            if (isLink(manifolds[i]->getBody0()) || isLink(manifolds[i]->getBody1()))
                convertMultiBodyContact(manifolds[i], both_directions);
            else
                convertContact(manifolds[i], info);
        }
        btMultiBodyConstraintSolver::convertContacts(nullptr, 0, info); // Adds the rows of the joints.
    }

private:
    LinkSolver links_;
    std::vector<btMultiBodyConstraint*> joints_; ///< belong to the group that is solved; kept to reuse memory

    static bool isLink(const btCollisionObject* object) { return btMultiBodyLinkCollider::upcast(object) != nullptr; }
};

/// While it contains no articulated body, it steps like a plain world of rigid bodies, bit for bit and as fast.
class BulletWorld : public btMultiBodyDynamicsWorld {
public:
    /// All arguments must outlive the world.
    /// Solves rigid bodies with `rigid_solver`; does not update the bounding boxes of sleeping bodies.
    BulletWorld(btDispatcher& dispatcher, btBroadphaseInterface& broadphase, btConstraintSolver& rigid_solver,
                BulletSolver& link_solver, btCollisionConfiguration& configuration)
        : btMultiBodyDynamicsWorld(&dispatcher, &broadphase, &link_solver, &configuration) {
        btDiscreteDynamicsWorld::setConstraintSolver(&rigid_solver);
        getSolverInfo().m_solverMode &= ~SOLVER_USE_2_FRICTION_DIRECTIONS;
        getSolverInfo().m_minimumSolverBatchSize = -1; // Each island is solved by itself, also one without contacts.
        setForceUpdateAllAabbs(false);
    }

    /// Each function below calls the variant for rigid bodies as long as there is no articulated body.
    void clearForces() override { plain() ? Rigid::clearForces() : Linked::clearForces(); }
    void applyGravity() override { plain() ? Rigid::applyGravity() : Linked::applyGravity(); }
    void integrateTransforms(btScalar dt) override {
        plain() ? Rigid::integrateTransforms(dt) : Linked::integrateTransforms(dt);
    }
    void predictUnconstraintMotion(btScalar dt) override {
        plain() ? Rigid::predictUnconstraintMotion(dt) : Linked::predictUnconstraintMotion(dt);
    }
    void saveKinematicState(btScalar dt) override {
        plain() ? Rigid::saveKinematicState(dt) : Linked::saveKinematicState(dt);
    }

protected:
    void calculateSimulationIslands() override {
        plain() ? Rigid::calculateSimulationIslands() : Linked::calculateSimulationIslands();
    }
    void updateActivationState(btScalar dt) override {
        plain() ? Rigid::updateActivationState(dt) : Linked::updateActivationState(dt);
    }
    void solveConstraints(btContactSolverInfo& info) override {
        plain() ? Rigid::solveConstraints(info) : Linked::solveConstraints(info);
    }

private:
    using Rigid = btDiscreteDynamicsWorld;
    using Linked = btMultiBodyDynamicsWorld;

    /// True while the world contains no articulated body.
    bool plain() const { return getNumMultibodies() == 0; }
};

} // namespace usar::sim
