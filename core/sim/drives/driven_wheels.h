// Wheels that turn at a wanted spin, and reach it with limited torque and acceleration. Part of the drives.
#pragma once

#include <vector>

#include "core/sim/drives/driven_joints.h"

namespace usar::sim {

/// Positive spin rolls forward, whichever way a wheel's axis points. A wheel that is told to stand brakes and then
/// holds its angle: a spin of 0 alone lets a robot creep down a slope. One that got a command of its own is left alone
/// until the whole drive is told something again.
class DrivenWheels {
public:
    /// Without an acceleration limit (rad/s2) where it is 0.
    DrivenWheels(DrivenJoints& joints, const std::vector<std::size_t>& wheels, double acceleration_rad_s2);

    std::size_t count() const { return wheels_.size(); }
    std::size_t joint(std::size_t wheel) const { return wheels_[wheel].joint; }
    void want(std::size_t wheel, double spin_rad_s);
    /// Its motor belongs to somebody else from now on.
    void leave(std::size_t joint);
    void takeBack();
    void step(Seconds dt);
    /// All are told to stand, and brake.
    bool braking() const;
    /// The least of the wheels' largest spins.
    double largestSpin() const;
    double largestTorque() const;

private:
    struct Wheel {
        std::size_t joint = 0;
        double sign = 1.0;
        double wanted_rad_s = 0.0;
        double now_rad_s = 0.0; ///< what it was told, on its way to what is wanted
        bool ours = true;
        bool told = false;
        bool held = false;
    };

    void brake(Wheel& wheel);

    DrivenJoints& joints_;
    std::vector<Wheel> wheels_;
    double acceleration_rad_s2_;
};

} // namespace usar::sim
