#include "core/sim/physics/bullet_world.h"

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>

namespace usar::sim {

namespace {

constexpr int link_iterations = 20;

bool isLink(const btCollisionObject* object) {
    return btMultiBodyLinkCollider::upcast(object) != nullptr;
}

} // namespace

void BulletSolver::solveMultiBodyGroup(btCollisionObject** bodies, int body_count, btPersistentManifold** manifolds,
                                       int manifold_count, btTypedConstraint** constraints, int constraint_count,
                                       btMultiBodyConstraint** joints, int joint_count, const btContactSolverInfo& info,
                                       btIDebugDraw* drawer, btDispatcher* dispatcher) {
    btContactSolverInfo thorough = info;
    thorough.m_numIterations = link_iterations;
    btMultiBodyConstraintSolver::solveMultiBodyGroup(bodies, body_count, manifolds, manifold_count, constraints,
                                                     constraint_count, joints, joint_count, thorough, drawer,
                                                     dispatcher);
}

void BulletSolver::convertContacts(btPersistentManifold** manifolds, int count, const btContactSolverInfo& info) {
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

BulletWorld::BulletWorld(btDispatcher& dispatcher, btBroadphaseInterface& broadphase, btConstraintSolver& rigid_solver,
                         BulletSolver& link_solver, btCollisionConfiguration& configuration)
    : btMultiBodyDynamicsWorld(&dispatcher, &broadphase, &link_solver, &configuration) {
    btDiscreteDynamicsWorld::setConstraintSolver(&rigid_solver);
    getSolverInfo().m_solverMode &= ~SOLVER_USE_2_FRICTION_DIRECTIONS;
    setForceUpdateAllAabbs(false);
}

} // namespace usar::sim
