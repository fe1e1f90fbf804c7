// USARBot.AirRobot: the flying body with its nine sonars, belly scanner, INS and ground truth.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/sim/robots/air_robot_body.h"
#include "core/sim/robots/air_robot_sensors.h"
#include "core/sim/robots/robot.h"

namespace usar::sim {

/// Thesis equipment (robots-and-worlds 3.1). Owned by its client's session.
class AirRobot : public Robot {
public:
    /// Raises the robot by up to a meter until it is free, as the game's engine does, and puts it beside another robot
    /// that has its place; fails where that is not enough.
    static Result<std::unique_ptr<Robot>> spawn(const RobotSurroundings& surroundings, const RobotOptions& options);

    AirRobot(const RobotSurroundings& surroundings, const RobotOptions& options);

    void obey(const protocol::Command& command) override;
    void beforeStep(Seconds dt) override { body_.beforeStep(dt); }
    void afterStep(Seconds dt) override { body_.afterStep(dt); }
    void measure(Seconds now, bool first, std::vector<protocol::InfoMessage>& out) override;
    bool alive() const override { return body_.batteryLeft() > Seconds{0.0}; }
    protocol::GeometryInfo geometry(const std::string& type, const std::string& name) const override;
    protocol::ConfigurationInfo configuration(const std::string& type, const std::string& name) const override;
    bool set(const protocol::SetInsPose& wanted) override;
    RobotFigures figures() const override;

private:
    protocol::RobotState state(Seconds now) const;

    AirRobotBody body_;
    WorldRays rays_;
    AirRobotSensors sensors_;
};

} // namespace usar::sim
