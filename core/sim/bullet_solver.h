// Bullet's constraint solver with friction in one direction for rigid bodies and in two for links. Internal to the
// physics.
#pragma once

#include <BulletDynamics/Featherstone/btMultiBodyConstraintSolver.h>

namespace usar::sim {

/// Rigid bodies slide along their friction: one direction does, is half the work and lets a body rest. Links know no
/// direction of sliding and need both; Bullet has one switch for all contacts.
class BulletSolver : public btMultiBodyConstraintSolver {
public:
    /// To be called once for the world: the switch as rigid bodies want it.
    static void prepare(btContactSolverInfo& info) { info.m_solverMode &= ~SOLVER_USE_2_FRICTION_DIRECTIONS; }

protected:
    void convertContacts(btPersistentManifold** manifolds, int count, const btContactSolverInfo& info) override;
};

} // namespace usar::sim
