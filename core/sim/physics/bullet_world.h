// Bullet's dynamics world for articulated bodies, which costs nothing while there are none. Internal to the physics.
#pragma once

#include <BulletDynamics/Featherstone/btMultiBodyConstraintSolver.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>
#include <btBulletDynamicsCommon.h>

namespace usar::sim {

/// Solver for contacts and joints. One direction of friction suffices for rigid bodies: it halves the cost and lets a
/// body come to rest. Links of articulated bodies have no direction of sliding and need two, but Bullet has one switch
/// for all contacts. Links also need more iterations, because Bullet does not remember their impulses from the last
/// step.
class BulletSolver : public btMultiBodyConstraintSolver {
public:
    void solveMultiBodyGroup(btCollisionObject** bodies, int body_count, btPersistentManifold** manifolds,
                             int manifold_count, btTypedConstraint** constraints, int constraint_count,
                             btMultiBodyConstraint** joints, int joint_count, const btContactSolverInfo& info,
                             btIDebugDraw* drawer, btDispatcher* dispatcher) override;

protected:
    void convertContacts(btPersistentManifold** manifolds, int count, const btContactSolverInfo& info) override;
};

/// While it contains no articulated body, it steps like a plain world of rigid bodies, bit for bit and as fast.
class BulletWorld : public btMultiBodyDynamicsWorld {
public:
    /// All arguments must outlive the world.
    BulletWorld(btDispatcher& dispatcher, btBroadphaseInterface& broadphase, btConstraintSolver& rigid_solver,
                BulletSolver& link_solver, btCollisionConfiguration& configuration);

    void clearForces() override;
    void applyGravity() override;
    void integrateTransforms(btScalar dt) override;
    void predictUnconstraintMotion(btScalar dt) override;
    void saveKinematicState(btScalar dt) override;

protected:
    void calculateSimulationIslands() override;
    void updateActivationState(btScalar dt) override;
    void solveConstraints(btContactSolverInfo& info) override;

private:
    bool plain() const { return getNumMultibodies() == 0; }
};

} // namespace usar::sim
