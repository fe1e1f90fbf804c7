// The flying body of an AirRobot: motors, autopilot, contacts, battery. Its sensors are not part of it.
#pragma once

#include "core/protocol/command.h"
#include "core/sim/physics/physics.h"
#include "core/sim/robots/air_robot_parameters.h"
#include "core/sim/robots/collision_counter.h"
#include "core/sim/robots/flight_controller.h"
#include "core/sim/robots/rotors.h"

namespace usar::sim {

/// Idle: motors off on the ground. Settling: the legs have found the ground, and the lift is gently taken away.
/// SpoolingUp: the lift returns while it is still on its legs. Broken and Dead (empty battery): it never flies again.
enum class MotorState { Idle, SpoolingUp, Flying, Settling, Broken, Dead };

/// Initial conditions of an AirRobot.
struct AirRobotSpawn {
    Pose base_in_map;
    bool near_ground = false; ///< lands by itself if true; otherwise it hovers where it was spawned
    Seconds battery_life{1200.0};
};

/// Breaks on a contact of a rotor disc, on an impulse above 0.5 N s, and on touching down at 1 m/s or faster; then it
/// falls without control (robots-and-worlds.md 3.1). It has landed when its legs are on the ground while it is told to
/// sink: the motors then go idle until it is told to climb. `physics` must outlive it; belongs to one Simulation.
class AirRobotBody {
public:
    /// Adds a body made from the parameters, and removes it when destroyed.
    AirRobotBody(Physics& physics, const AirRobotSpawn& spawn, AirRobotParameters parameters = {});
    /// Flies a body that the caller has added and will remove.
    AirRobotBody(Physics& physics, BodyId body, const AirRobotSpawn& spawn, AirRobotParameters parameters);
    ~AirRobotBody();
    AirRobotBody(const AirRobotBody&) = delete;
    AirRobotBody& operator=(const AirRobotBody&) = delete;

    /// Sets the velocity command. Absent terms keep their value; all are clamped to the robot's limits, of which they
    /// are percentages when normalized.
    void drive(const protocol::AerialDrive& drive);
    /// Applies the forces of the next physics step.
    void beforeStep(Seconds dt);
    /// Evaluates the contacts of the physics step that was made, and updates the counters.
    void afterStep(Seconds dt);

    BodyId id() const { return id_; }
    BodyState state() const { return physics_.state(id_); }
    const AirRobotParameters& parameters() const { return parameters_; }
    const VelocityCommand& command() const { return command_; }
    MotorState motors() const { return motors_; }
    bool broken() const { return motors_ == MotorState::Broken; }
    /// Sets the velocity of the air (map frame), relative to which drag acts.
    void setWind(const Vec3& wind_in_map_m_s) { wind_m_s_ = wind_in_map_m_s; }
    /// For faults that weaken a rotor.
    Rotors& rotors() { return rotors_; }
    /// Empties the battery.
    void switchOff() { battery_left_ = Seconds{0.0}; }
    /// True if no rotor pushes: idle on the ground, broken, or without battery.
    bool motorsOff() const { return motors_ == MotorState::Idle || ended(); }
    /// True if it stands or lies still with its motors off.
    bool atRest() const;
    Seconds batteryLeft() const { return battery_left_; }
    int collisions() const { return collisions_.count(); }
    /// Length of the path flown.
    double distance_m() const { return distance_m_; }

private:
    RotorWrench wantedWrench(const BodyState& state, Seconds dt);
    void feelContacts();
    bool isTouchdown(const Contact& contact) const;
    void touchDown();
    void leaveGround();
    void enter(MotorState motors);
    bool ended() const { return motors_ == MotorState::Broken || motors_ == MotorState::Dead; }

    Physics& physics_;
    AirRobotParameters parameters_;
    BodyId id_;
    bool owns_body_;
    Rotors rotors_;
    FlightController controller_;
    VelocityCommand command_;
    Vec3 wind_m_s_ = Vec3::Zero();
    MotorState motors_ = MotorState::Flying;
    bool landing_itself_ = false; ///< sinks without a command, until it gets one
    Seconds in_state_{0.0};       ///< time since `motors_` last changed
    Seconds since_gear_{1e9};     ///< time since the legs last touched something to stand on
    Seconds battery_left_;
    Vec3 last_position_m_;
    double distance_m_ = 0.0;
    CollisionCounter collisions_;
};

} // namespace usar::sim
