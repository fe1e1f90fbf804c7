// Solves the contacts and joints of articulated bodies that touch one another and the fixed world only. Internal to the
// physics.
#pragma once

#include <span>
#include <vector>

#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <BulletDynamics/Featherstone/btMultiBodyConstraint.h>
#include <btBulletDynamicsCommon.h>

#include "core/sim/physics/mass_matrix.h"

namespace usar::sim {

/// One joint is brought to a speed during a step, by an impulse between two limits: this is a motor, a brake or an end
/// stop.
struct JointRow {
    int dof = 0;          ///< index of the joint in the body's velocities, from 6
    double speed = 0.0;   ///< wanted, rad/s or m/s
    double low_n_s = 0.0; ///< or N m s
    double high_n_s = 0.0;
    double* impulse = nullptr; ///< what it took in the last step, and then in this one
};

/// The inverse mass matrix that was computed last, for the base's axes, and the joints' positions then. It turns with
/// the body, so that it holds until a joint moves.
struct KeptInverse {
    std::vector<double> in_base; ///< empty: none yet
    std::vector<double> joints;
};

/// A body whose joints are driven. It is the user pointer of its btMultiBody.
class JointedBody {
public:
    virtual ~JointedBody() = default;
    /// True if wheels are all that can touch something besides its base: no legs, flippers or fingers.
    virtual bool onWheels() const = 0;
    /// The rows for this step, valid until the next one.
    virtual std::span<const JointRow> jointRows(double dt_s) = 0;
    /// False for the joint of a round wheel, whose turning moves no mass elsewhere.
    virtual bool movesMass(int link) const = 0;
    virtual KeptInverse& keptInverse() = 0;
    /// Its motors and stops for Bullet's solver, with their limits for this step. Bullet's world would look through
    /// those of all robots for each group of bodies, and they are needed only where a robot touches a thing that moves.
    virtual std::span<btMultiBodyConstraint* const> ownConstraints(double dt_s) = 0;
};

/// The jointed body that this is the base of; nullptr for links and for rigid bodies.
JointedBody* jointedBodyOf(const btCollisionObject& object);
/// True for a link or the base of a robot that is on wheels.
bool isOnWheels(const btCollisionObject& object);

/// The method is Bullet's, projected Gauss-Seidel on velocities with the same rows: each contact pushes apart and
/// rubs in two directions. It takes a fraction of the time, because the inverse of each body's mass matrix is computed
/// when a joint has moved instead of once for each row, and because it ends when nothing changes any more. A step
/// begins with the impulses of the last one if all robots are on wheels. With limbs it begins at zero: otherwise the
/// ERS turns this way and that as it walks, and the Kenaf does not get its flippers over a step in
/// `tst_tracked_robots`.
class LinkSolver {
public:
    /// True if all bodies are links of robots.
    static bool canSolve(std::span<btCollisionObject* const> bodies);
    /// Changes the bodies' velocities. The manifolds are those of the bodies; their points keep the impulses.
    void solve(std::span<btCollisionObject* const> bodies, std::span<btPersistentManifold* const> manifolds,
               const btContactSolverInfo& info);

private:
    /// A body with its inverse mass matrix, which is `size` x `size`, and the change of its velocities.
    struct Member {
        btMultiBody* body = nullptr;
        int size = 0;
        std::size_t inverse = 0; ///< offsets into `numbers_`
        std::size_t change = 0;
        std::size_t axes = 0; ///< first axis in `axes_`
    };
    /// How one body takes part in a row.
    struct Side {
        int member = -1;
        std::size_t jacobian = 0; ///< offsets into `numbers_`
        std::size_t response = 0; ///< change of velocities by a unit impulse
    };
    struct Row {
        Side a;
        Side b;
        double wanted = 0.0;    ///< change of the relative velocity, m/s or rad/s
        double mobility = 0.0;  ///< relative velocity that a unit impulse gives
        double stiffness = 0.0; ///< 1 / `mobility`, or 0 if there is none
        double low = 0.0;       ///< limits of the impulse, N s
        double high = 0.0;
        double impulse = 0.0;
        double rubbing = 0.0;   ///< share of the impulse of `normal` that limits this row
        int normal = -1;        ///< the row that presses; -1: the limits are fixed
        int dof = -1;           ///< the joint that the row is about; -1: it is a contact
        double* kept = nullptr; ///< where the impulse is kept for the next step
    };
    /// Direction and place at which a row acts on a body.
    struct Push {
        btVector3 point_m;
        btVector3 force;  ///< unit vector, or zero
        btVector3 torque; ///< unit vector, or zero
    };

    void addMember(btMultiBody& body);
    /// Fills in the inverse mass matrix for the map's axes.
    void invert(const Member& member);
    void addJoints(int member, double dt_s);
    void addContacts(btPersistentManifold& manifold, const btContactSolverInfo& info);
    void addContact(const btPersistentManifold& manifold, btManifoldPoint& point, const btContactSolverInfo& info);
    /// Adds a row between the two sides of a manifold, and sets the relative velocity.
    Row& addRow(std::vector<Row>& rows, const btPersistentManifold& manifold, const btManifoldPoint& point,
                const btVector3& force, const btVector3& torque, double& speed);
    Side sideOf(const btCollisionObject& object, const Push& push, double& speed, double& mobility);
    void fillJacobian(const Member& member, int link, const Push& push, double* jacobian) const;
    /// One sweep over all rows; returns the largest change of a relative velocity.
    double sweep(bool backward);
    double resolve(Row& row);
    /// Sets the first impulses: those of the last step if `warm`, otherwise zero.
    void begin(bool warm);

    std::vector<Member> members_;
    std::vector<JointAxis> axes_;
    std::vector<Row> joints_;
    std::vector<Row> normals_;
    std::vector<Row> frictions_;
    std::vector<double> numbers_;
};

} // namespace usar::sim
