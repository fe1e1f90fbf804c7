// Wheels that turn at a wanted spin and reach it with limited torque and acceleration. Part of the drives.
#pragma once

#include <vector>

#include "core/sim/drives/driven_joints.h"

namespace usar::sim {

/// Positive spin rolls forward, whichever way a wheel's axis points. A wheel that is told to stand brakes and then
/// holds its angle, because a spin of 0 alone lets a robot creep down a slope. A wheel that got a command of its own is
/// left alone until the whole drive is commanded again.
class DrivenWheels {
public:
    /// The acceleration is unlimited if `acceleration_rad_s2` is 0. `joints` must outlive it.
    DrivenWheels(DrivenJoints& joints, const std::vector<std::size_t>& wheels, double acceleration_rad_s2);

    std::size_t count() const { return wheels_.size(); }
    std::size_t joint(std::size_t wheel) const { return wheels_[wheel].joint; } ///< index of the link on its joint
    /// Sets the spin that the wheel is to reach.
    void want(std::size_t wheel, double spin_rad_s);
    /// Leaves the wheel on this joint, if there is one, to a command of its own.
    void leave(std::size_t joint);
    /// Drives all wheels again, from the speeds that they have now.
    void takeBack();
    /// Gives the motors their setpoints for the next physics step.
    void step(Seconds dt);
    /// True if all wheels are told to stand, and brake.
    bool braking() const;
    /// The smallest of the wheels' speed limits, rad/s.
    double largestSpin() const;
    double largestTorque() const; ///< that of the first wheel, N m

private:
    struct Wheel {
        std::size_t joint = 0;
        double sign = 1.0;
        double wanted_rad_s = 0.0;
        double now_rad_s = 0.0; ///< current setpoint on its way to the wanted spin
        bool ours = true;       ///< false while it has a command of its own
        bool told = false;      ///< has got a setpoint
        bool held = false;      ///< holds its angle
    };

    void brake(Wheel& wheel);

    DrivenJoints& joints_;
    std::vector<Wheel> wheels_;
    double acceleration_rad_s2_;
};

} // namespace usar::sim
