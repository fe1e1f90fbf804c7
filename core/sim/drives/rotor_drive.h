// Four rotors under the AirRobot's autopilot, as a drive.
#pragma once

#include "core/sim/robots/air_robot_body.h"
#include "core/sim/robots/drive.h"

namespace usar::sim {

/// The drive's settings are the figures of AirRobotParameters by name, without units: forward_limit, thrust_limit,
/// tilt_limit …
class RotorDrive : public Drive {
public:
    /// `physics` must outlive it; the body belongs to the caller.
    RotorDrive(const RobotModel& model, Physics& physics, BodyId body, const DriveBirth& birth);

    bool obey(const protocol::Command& command) override;
    void beforeStep(Seconds dt) override { body_.beforeStep(dt); }
    void afterStep(Seconds dt) override { body_.afterStep(dt); }
    void feelWind(const Vec3& wind_in_map_m_s) override { body_.setWind(wind_in_map_m_s); }
    bool weakenRotor(int rotor, double share) override;
    void switchOff() override { body_.switchOff(); }
    bool idle() const override { return body_.motorsOff(); }
    bool broken() const override { return body_.broken(); }
    int collisions() const override { return body_.collisions(); }
    using Drive::addTo;
    void addTo(std::vector<protocol::Setting>& settings) const override;

private:
    AirRobotBody body_;
};

/// The default parameters, overridden by the figures that the model gives.
AirRobotParameters airRobotParametersOf(const RobotModel& model);

} // namespace usar::sim
