// Four rotors under the AirRobot's autopilot, as a drive: motors, autopilot and contacts.
#pragma once

#include "core/sim/robots/air_robot_parameters.h"
#include "core/sim/robots/drive.h"
#include "core/sim/robots/flight_controller.h"

namespace usar::sim {

/// Idle: motors off on the ground. Settling: the legs have found the ground, and the lift is gently taken away.
/// SpoolingUp: the lift returns while it is still on its legs. Broken and Dead (switched off): it never flies again.
enum class MotorState { Idle, SpoolingUp, Flying, Settling, Broken, Dead };

/// Breaks when something gets past the ring guard to a rotor disc, on an impulse above 0.5 N s, and on touching down at
/// 1 m/s or faster; then it falls without control (robots-and-worlds.md 3.1). It has landed when its legs are on the
/// ground while it is told to sink: the motors then go idle until it is told to climb.
class RotorDrive : public Drive {
public:
    /// Flies this body, and lands by itself if it is `near_ground`. `physics` must outlive it.
    RotorDrive(Physics& physics, BodyId body, bool near_ground, const AirRobotParameters& parameters = {});

    /// Obeys protocol::AerialDrive alone. Absent terms keep their value; all are clamped to the robot's limits, of
    /// which they are percentages when normalized.
    bool obey(const protocol::Command& command) override;
    void beforeStep(Seconds dt) override;
    void afterStep(Seconds dt) override;
    void feelWind(const Vec3& wind_in_map_m_s) override;
    void weakenRotor(int rotor, double share) override;
    /// The motors stop at the end of the next step.
    void switchOff() override { off_ = true; }
    /// True if no rotor pushes: idle on the ground, broken, or switched off.
    bool idle() const override { return motors_ == MotorState::Idle || ended(); }
    bool broken() const override { return motors_ == MotorState::Broken; }
    bool weak() const override { return rotors_.weak(); }
    void addSettings(std::vector<protocol::Setting>& settings) const override;

    BodyState state() const { return physics_.state(id_); }
    const VelocityCommand& command() const { return command_; }
    MotorState motors() const { return motors_; }

private:
    RotorWrench wantedWrench(const BodyState& state, Seconds dt);
    void feelContacts();
    /// True if the contact is in a rotor's disc, and the ring guard does not keep the thing from the rotor.
    bool reachesRotor(const Contact& contact) const;
    bool isTouchdown(const Contact& contact) const;
    void touchDown();
    void leaveGround();
    void enter(MotorState motors);
    /// Lets the body sleep while nothing pushes it.
    void mayRest();
    bool ended() const { return motors_ == MotorState::Broken || motors_ == MotorState::Dead; }

    Physics& physics_;
    AirRobotParameters parameters_;
    BodyId id_;
    Rotors rotors_;
    FlightController controller_;
    VelocityCommand command_;
    Vec3 wind_m_s_ = Vec3::Zero();
    bool calm_ = true; ///< no wind to speak of
    MotorState motors_ = MotorState::Flying;
    bool landing_itself_;     ///< sinks without a command, until it gets one
    Seconds in_state_{0.0};   ///< time since `motors_` last changed
    Seconds since_gear_{1e9}; ///< time since the legs last touched something to stand on
    bool off_ = false;        ///< switched off
};

} // namespace usar::sim
