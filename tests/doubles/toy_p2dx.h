// A kinematic P2DX in a room of boxes, and a run of a behavior on it: message values, no text, no physics.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/agent/behavior_host.h"

namespace usar::test {

struct ToyBox {
    Rectangle at_m;
    bool low = false; ///< below the scanner: only the sonars notice it
};

/// Walls around, boxes within, and ground that may slope.
struct ToyRoom {
    Rectangle walls_m{{-50.0, -50.0}, {50.0, 50.0}};
    std::vector<ToyBox> boxes;
    std::function<double(const Vec2&)> ground_m = [](const Vec2&) { return 0.0; };

    double cast(const Vec2& from_m, double direction_rad, double maximum_m, bool sees_low) const;
    /// Whether a disc of the robot's size there would touch something.
    bool touches(const Vec2& at_m) const;
};

/// Its wheels spin as they are told at once; what is in the way holds it. Sensors at 5 Hz, told after the state as
/// UT2004 does.
class ToyP2dx {
public:
    ToyP2dx(ToyRoom room, const Pose& start_in_map);

    void obey(const protocol::Command& command);
    std::vector<protocol::InfoMessage> step();

    Seconds now() const { return now_; }
    Vec2 position_m() const { return base_.position_m.head<2>(); }
    double yaw_rad() const { return base_.yaw_rad; }
    const protocol::SkidDrive& drive() const { return drive_; }
    /// Touches; one that lasts is one.
    int collisions() const { return collisions_; }
    /// Longest time within a meter.
    Seconds longestStay() const { return longest_stay_; }

    bool scanner_silent = false;
    bool scanner_frozen = false; ///< it says its last scan again
    bool stuck = false;          ///< its wheels turn and it does not move

private:
    void move(double dt_s);
    void watchStay();

    ToyRoom room_;
    Pose base_;
    protocol::SkidDrive drive_{0.0, 0.0};
    Seconds now_{100.0};
    bool touching_ = false;
    int collisions_ = 0;
    Vec2 stays_at_m_;
    Seconds stays_since_{100.0};
    Seconds longest_stay_{0.0};
    std::vector<double> ranges_m_; ///< of the last scan
};

/// The behavior on the robot; keeps what it said.
class ToyDrive {
public:
    ToyDrive(ToyP2dx robot, std::unique_ptr<agent::Behavior> behavior);

    void tick();
    void run(Seconds duration);
    /// Until the robot is in that state; false when it does not come to that within five minutes.
    bool runInto(const std::string& state);
    void order(agent::Order order);

    ToyP2dx& robot() { return robot_; }
    const agent::BehaviorStatus& status() const { return status_; }
    const std::vector<agent::CausedCommand>& commands() const { return commands_; }
    const std::vector<std::string>& events() const { return events_; }
    const std::optional<agent::BehaviorFinished>& ending() const { return ending_; }

private:
    void keep(agent::BehaviorHost::Output output);

    ToyP2dx robot_;
    agent::BehaviorHost host_;
    LineNumber line_;
    agent::BehaviorStatus status_;
    std::vector<agent::CausedCommand> commands_;
    std::vector<std::string> events_;
    std::optional<agent::BehaviorFinished> ending_;
};

} // namespace usar::test
