#include "core/sim/physics/bullet_multi_body.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include "core/sim/physics/bullet_ground.h"

namespace usar::sim {

namespace {

// Time constant with which a position motor that nothing holds back reaches its target: short compared with a gait,
// long compared with a physics step.
constexpr Seconds servo_time{0.02};
constexpr double no_clamp = 1e30;
constexpr double sleepy_joint = 0.05; // In rad/s or m/s.
constexpr double joint_erp = 0.2;     // Share of a violation of a joint's limit that a step mends, as in Bullet.
constexpr double limit_n_s = 100.0;   // Largest impulse of a joint's limit in a step, or N m s, as in Bullet.

// A torque is commanded as a velocity motor of limited strength whose target is the largest speed.
double speedTarget(const JointMotor& motor) {
    return motor.mode == JointMotor::Mode::Torque ? std::copysign(motor.largest_speed, motor.target) : motor.target;
}

double strengthOf(const JointMotor& motor) {
    return motor.mode == JointMotor::Mode::Torque ? std::min(std::abs(motor.target), motor.limit) : motor.limit;
}

std::size_t at(int link) {
    return static_cast<std::size_t>(link + 1);
}

/// True if a link is the same however its joint is turned, and carries nothing.
bool isRoundWheel(const ArticulatedDescription& description, std::size_t index) {
    constexpr double same = 1e-9;
    const LinkDescription& link = description.links[index];
    const Vec3& axis = link.axis_in_link;
    const Vec3& inertia_kg_m2 = link.body.inertia_kg_m2;
    int along = 0;
    axis.cwiseAbs().maxCoeff(&along);
    const bool balanced = (link.pivot_in_link_m - link.pivot_in_link_m.dot(axis) * axis).norm() < same;
    const bool round = std::abs(inertia_kg_m2[(along + 1) % 3] - inertia_kg_m2[(along + 2) % 3]) < same;
    return link.kind == JointKind::Revolute && std::abs(std::abs(axis[along]) - 1.0) < same && balanced && round &&
           std::ranges::none_of(description.links,
                                [&](const LinkDescription& other) { return other.parent == static_cast<int>(index); });
}

bool hasOnlyWheels(const ArticulatedDescription& description) {
    const auto isWheel = [](const BodyPart& part) { return std::holds_alternative<CylinderShape>(part.shape); };
    return std::ranges::all_of(
        description.links, [&](const LinkDescription& link) { return std::ranges::all_of(link.body.parts, isWheel); });
}

} // namespace

BulletMultiBody::BulletMultiBody(btMultiBodyDynamicsWorld& world, const ArticulatedDescription& description,
                                 const Pose& base_in_map, BodyId id)
    : world_(world)
    , body_(static_cast<int>(description.links.size()), description.base.mass_kg,
            toBullet(description.base.inertia_kg_m2), /*fixedBase=*/false, /*canSleep=*/false)
    , joints_(description.links.size())
    , velocities_(description.links.size() + 1)
    , rates_(description.links.size() + 1) {
    body_.setUserPointer(static_cast<JointedBody*>(this));
    body_.setHasSelfCollision(false);
    body_.setLinearDamping(0.0);
    body_.setAngularDamping(0.0);
    // Bullet compares this with the sum of the squares of the base's speeds and of all joint speeds.
    body_.setSleepThreshold(sleepy_m_s * sleepy_m_s + sleepy_rad_s * sleepy_rad_s + sleepy_joint * sleepy_joint);
    on_wheels_ = hasOnlyWheels(description);
    for (std::size_t i = 0; i < joints_.size(); ++i)
        joints_[i].moves_mass = !isRoundWheel(description, i);
    for (std::size_t i = 0; i < description.links.size(); ++i)
        addLink(static_cast<int>(i), description.links[i]);
    body_.finalizeMultiDof();
    world_.addMultiBody(&body_);
    addPiece(-1, description.base, id);
    for (std::size_t i = 0; i < description.links.size(); ++i)
        addPiece(static_cast<int>(i), description.links[i].body, id);
    place(base_in_map);
    for (std::size_t i = 0; i < description.links.size(); ++i)
        addConstraints(static_cast<int>(i), description.links[i]);
}

BulletMultiBody::~BulletMultiBody() {
    for (const Piece& part : parts_)
        world_.removeCollisionObject(part.collider.get());
    world_.removeMultiBody(&body_);
}

void BulletMultiBody::addLink(int index, const LinkDescription& link) {
    const Eigen::Quaterniond from_parent = link.link_in_parent.rotation().conjugate();
    const btQuaternion rotation(from_parent.x(), from_parent.y(), from_parent.z(), from_parent.w());
    const btVector3 inertia = toBullet(link.body.inertia_kg_m2);
    const btVector3 axis = toBullet(link.axis_in_link);
    const btVector3 pivot_in_parent = toBullet(link.link_in_parent * link.pivot_in_link_m);
    const btVector3 center_from_pivot = toBullet(Vec3(-link.pivot_in_link_m));
    const auto setup = link.kind == JointKind::Revolute ? &btMultiBody::setupRevolute : &btMultiBody::setupPrismatic;
    (body_.*setup)(index, link.body.mass_kg, inertia, link.parent, rotation, axis, pivot_in_parent, center_from_pivot,
                   true);
}

// Links that touch nothing need a collider too: Bullet finds a joint's motor and limits through it.
void BulletMultiBody::addPiece(int link, const BodyDescription& description, BodyId id) {
    Piece part(description);
    part.collider = std::make_unique<btMultiBodyLinkCollider>(&body_, link);
    part.collider->setCollisionShape(part.shape.compound());
    markAsBody(*part.collider, description, id, link);
    part.collider->setRestitution(description.restitution);
    if (link < 0)
        body_.setBaseCollider(part.collider.get());
    else
        body_.getLink(link).m_collider = part.collider.get();
    world_.addCollisionObject(part.collider.get(), body_group, part.shape.empty() ? 0 : ground_group | body_group);
    pieces_.push_back({part.collider.get(), part.shape.radius_m()});
    parts_.push_back(std::move(part));
}

void BulletMultiBody::addConstraints(int index, const LinkDescription& link) {
    Joint& joint = joints_[static_cast<std::size_t>(index)];
    if (link.lower <= link.upper) {
        joint.limits = std::make_unique<btMultiBodyJointLimitConstraint>(&body_, index, link.lower, link.upper);
        own_constraints_.push_back(joint.limits.get());
    }
    joint.damping = link.damping;
    joint.lower = link.lower;
    joint.upper = link.upper;
    if (link.damping > 0.0) {
        joint.damper = std::make_unique<btMultiBodyJointMotor>(&body_, index, 0.0, 0.0);
        own_constraints_.push_back(joint.damper.get());
    }
}

void BulletMultiBody::place(const Pose& base_in_map) {
    body_.setBaseWorldTransform(toBullet(base_in_map));
    body_.setBaseVel({0.0, 0.0, 0.0});
    body_.setBaseOmega({0.0, 0.0, 0.0});
    for (int link = 0; link < body_.getNumLinks(); ++link)
        body_.setJointVel(link, 0.0);
    body_.clearForcesAndTorques();
    moveColliders();
    refreshVelocities();
}

void BulletMultiBody::lift(double height_m) {
    body_.setBasePos(body_.getBasePos() + btVector3(0.0, 0.0, height_m));
    btVector3 velocity = body_.getBaseVel();
    velocity.setZ(std::max(velocity.z(), 0.0));
    body_.setBaseVel(velocity);
    moveColliders();
    refreshVelocities();
}

void BulletMultiBody::moveColliders() {
    btAlignedObjectArray<btQuaternion> rotations;
    btAlignedObjectArray<btVector3> origins;
    body_.forwardKinematics(rotations, origins);
    body_.updateCollisionObjectWorldTransforms(rotations, origins);
    for (const Piece& part : parts_)
        world_.updateSingleAabb(part.collider.get());
}

void BulletMultiBody::letSleep(bool allowed) {
    body_.setCanSleep(allowed);
    body_.wakeUp();
    for (const Piece& part : parts_)
        part.collider->forceActivationState(allowed ? ACTIVE_TAG : DISABLE_DEACTIVATION);
}

void BulletMultiBody::wake() {
    if (!body_.getCanSleep())
        return;
    body_.wakeUp();
    for (const Piece& part : parts_)
        part.collider->forceActivationState(ACTIVE_TAG);
}

const btTransform& BulletMultiBody::transform(int link) const {
    return parts_[at(link)].collider->getWorldTransform();
}

BodyState BulletMultiBody::state(int link) const {
    return bodyState(transform(link), velocities_[at(link)], rates_[at(link)]);
}

JointState BulletMultiBody::joint(std::size_t link) const {
    const int index = static_cast<int>(link);
    return {body_.getJointPos(index), body_.getJointVel(index)};
}

void BulletMultiBody::setMotor(std::size_t link, const JointMotor& motor) {
    Joint& joint = joints_.at(link);
    if (motor == joint.wanted)
        return;
    wake();
    joint.wanted = motor;
    const bool off = motor.mode == JointMotor::Mode::Off;
    if (off && joint.motor) {
        std::erase(own_constraints_, joint.motor.get());
        joint.motor.reset();
    }
    if (off)
        return;
    if (!joint.motor) {
        joint.motor = std::make_unique<btMultiBodyJointMotor>(&body_, static_cast<int>(link), 0.0, 0.0);
        own_constraints_.push_back(joint.motor.get());
    }
    const bool position = motor.mode == JointMotor::Mode::Position;
    joint.motor->setPositionTarget(position ? motor.target : 0.0, position ? 1.0 : 0.0);
    joint.motor->setVelocityTarget(position ? 0.0 : speedTarget(motor), 1.0);
    joint.motor->setRhsClamp(position ? motor.largest_speed : no_clamp);
}

void BulletMultiBody::apply(const Vec3& force_in_map_n, const Vec3& torque_in_map_n_m) {
    body_.addBaseForce(toBullet(force_in_map_n));
    body_.addBaseTorque(toBullet(torque_in_map_n_m));
}

std::span<btMultiBodyConstraint* const> BulletMultiBody::ownConstraints(double dt_s) {
    for (std::size_t i = 0; i < joints_.size(); ++i)
        drive(static_cast<int>(i), joints_[i], Seconds{dt_s});
    return own_constraints_;
}

void BulletMultiBody::drive(int index, Joint& joint, Seconds dt) {
    // A motor that holds a position or a speed must overcome the damping first. Left to the solver, the two would
    // settle somewhere in between.
    const double damping = joint.damping * std::abs(body_.getJointVel(index));
    const double strength = joint.motor ? strengthOf(joint.wanted) : 0.0;
    const double overcome = joint.wanted.mode == JointMotor::Mode::Torque ? 0.0 : std::min(damping, strength);
    if (joint.damper)
        joint.damper->setMaxAppliedImpulse((damping - overcome) * dt.count());
    if (joint.motor) {
        joint.motor->setMaxAppliedImpulse((strength - overcome) * dt.count());
        joint.motor->setErp(std::min(1.0, dt / servo_time));
    }
}

std::span<const JointRow> BulletMultiBody::jointRows(double dt_s) {
    rows_.clear();
    for (std::size_t i = 0; i < joints_.size(); ++i) {
        Joint& joint = joints_[i];
        const int link = static_cast<int>(i);
        const int dof = 6 + body_.getLink(link).m_dofOffset;
        const double position = body_.getJointPos(link);
        const double damping = joint.damping * std::abs(body_.getJointVel(link));
        const double strength = joint.motor ? strengthOf(joint.wanted) : 0.0;
        const double overcome = joint.wanted.mode == JointMotor::Mode::Torque ? 0.0 : std::min(damping, strength);
        if (joint.limits && (position <= joint.lower || position >= joint.upper)) {
            const bool below = position <= joint.lower;
            const double back = joint_erp * (below ? joint.lower - position : joint.upper - position) / dt_s;
            rows_.push_back({dof, back, below ? 0.0 : -limit_n_s, below ? limit_n_s : 0.0, &joint.limit_n_s});
        } else {
            joint.limit_n_s = 0.0;
        }
        if (const double most = (damping - overcome) * dt_s; most > 0.0)
            rows_.push_back({dof, 0.0, -most, most, &joint.damper_n_s});
        if (const double most = (strength - overcome) * dt_s; most > 0.0)
            rows_.push_back({dof, wantedSpeed(joint, position, dt_s), -most, most, &joint.motor_n_s});
    }
    return rows_;
}

double BulletMultiBody::wantedSpeed(const Joint& joint, double position, double dt_s) {
    if (joint.wanted.mode != JointMotor::Mode::Position)
        return speedTarget(joint.wanted);
    const double share = std::min(1.0, dt_s / servo_time.count());
    const double speed = share * (joint.wanted.target - position) / dt_s;
    return std::clamp(speed, -joint.wanted.largest_speed, joint.wanted.largest_speed);
}

// Bullet gives the velocities of links in their own frames.
void BulletMultiBody::refreshVelocities() {
    body_.compTreeLinkVelocities(rates_.data(), velocities_.data());
    for (std::size_t i = 0; i < parts_.size(); ++i) {
        const btMatrix3x3& rotation = parts_[i].collider->getWorldTransform().getBasis();
        velocities_[i] = rotation * velocities_[i];
        rates_[i] = rotation * rates_[i];
    }
}

btVector3 BulletMultiBody::velocityBefore(int link, const btVector3& point) const {
    return velocities_[at(link)] + rates_[at(link)].cross(point - transform(link).getOrigin());
}

} // namespace usar::sim
