// A kinematic AirRobot with its sensors, and a flight that runs a behavior on it: message values, no text, no physics.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/agent/behavior_host.h"
#include "core/base/random.h"
#include "robots/airrobot/flight/sensor_layout.h"
#include "tests/doubles/toy_world.h"

namespace usar::test {

struct ToyFaults {
    bool ins_drifts = false;
    bool slow = false;            ///< says that it flies at most 0.7 m/s and climbs at most 0.6 m/s
    bool silent_geometry = false; ///< GETGEO is never answered
    bool no_response = false;     ///< SET is obeyed without RES, as UDK does
    std::optional<double> sonars_silent_after_s{};
    std::optional<double> ins_silent_after_s{};
    std::string only_silent_sonar{}; ///< of the sonars only this one falls silent
    std::optional<double> lid_z_m{}; ///< its base gets no higher, and it sees no reason
};

/// First-order velocities, tilt from acceleration, sensors at 5 Hz. The INS starts after two scans at rest.
class ToyAirRobot {
public:
    ToyAirRobot(ToyWorld world, const Pose& start_in_map, ToyFaults faults = {}, Seconds battery = Seconds(1e5));

    void obey(const protocol::Command& command);
    /// Moves on by one message tick and tells what the server would send, in its order.
    std::vector<protocol::InfoMessage> step();

    Seconds now() const { return now_; }
    const Vec3& position_m() const { return base_.position_m; }
    /// Ticks that ended with the hull inside something, or that hit the ground fast.
    int collisions() const { return collisions_; }
    bool onGround() const { return on_ground_; }
    double lowestClearance_m() const { return lowest_clearance_m_; }

private:
    void move(double dt_s);
    void integrateIns();
    protocol::SonarReadings sonars() const;
    protocol::RangeScan scan() const;

    ToyWorld world_;
    ToyFaults faults_;
    airrobot::SensorLayout layout_ = airrobot::stockLayout();
    Pose base_;
    Vec3 velocity_m_s_ = Vec3::Zero();
    double yaw_rate_rad_s_ = 0.0;
    protocol::AerialDrive drive_{0.0, 0.0, 0.0, 0.0};
    std::vector<protocol::InfoMessage> answers_;
    Pose ins_;
    Pose ins_last_;
    int rest_scans_ = 0;
    Random random_{7};
    Seconds now_{100.0};
    Seconds started_{100.0};
    Seconds battery_;
    bool on_ground_ = true;
    int collisions_ = 0;
    double lowest_clearance_m_ = 1e9;
};

/// Runs a behavior on a toy robot until it finishes or `limit` has passed on the protocol clock.
class ToyFlight {
public:
    ToyFlight(ToyAirRobot robot, std::unique_ptr<agent::Behavior> behavior);

    void run(Seconds limit);
    void tick();
    void order(agent::Order order);
    void set(const agent::ParameterSet& parameters) { host_.setParameters(parameters); }

    ToyAirRobot& robot() { return robot_; }
    bool finished() const { return host_.finished(); }
    std::optional<agent::BehaviorFinished> ending() const;
    std::vector<agent::MapMark> marks(agent::MarkKind kind) const;
    std::vector<std::string> events() const;
    const agent::BehaviorStatus& status() const { return status_; }
    /// States in the order in which they were entered.
    const std::vector<std::string>& states() const { return states_; }
    const std::vector<agent::Published>& published() const { return published_; }
    const std::vector<agent::CausedCommand>& commands() const { return commands_; }
    const std::vector<Vec3>& path_m() const { return path_m_; }

private:
    void keep(agent::BehaviorHost::Output output);

    ToyAirRobot robot_;
    agent::BehaviorHost host_;
    LineNumber line_;
    agent::BehaviorStatus status_;
    std::vector<std::string> states_;
    std::vector<agent::Published> published_;
    std::vector<agent::CausedCommand> commands_;
    std::vector<Vec3> path_m_;
};

} // namespace usar::test
