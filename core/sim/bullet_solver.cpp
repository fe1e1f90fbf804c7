#include "core/sim/bullet_solver.h"

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>

namespace usar::sim {

void BulletSolver::convertContacts(btPersistentManifold** manifolds, int count, const btContactSolverInfo& info) {
    btContactSolverInfo both_directions = info;
    both_directions.m_solverMode |= SOLVER_USE_2_FRICTION_DIRECTIONS;
    for (int i = 0; i < count; ++i) {
        btPersistentManifold* const manifold = manifolds[i];
        if (btMultiBodyLinkCollider::upcast(manifold->getBody0()) ||
            btMultiBodyLinkCollider::upcast(manifold->getBody1()))
            convertMultiBodyContact(manifold, both_directions);
        else
            convertContact(manifold, info);
    }
    btMultiBodyConstraintSolver::convertContacts(nullptr, 0, info); // the joints' rows
}

} // namespace usar::sim
