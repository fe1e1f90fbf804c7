// An ERS after the ball: what it sees, and what it makes of it.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/agent/robot_plugin.h"
#include "core/agent/timed_run.h"
#include "core/modules/specific_sensor.h"
#include "robots/ers/gait.h"
#include "robots/ers/settings.h"

namespace usar::ers {

/// The thesis's robot (3.5.2): of its many sensors it needs the ball finder, so it has the sensor-specific module for
/// that one; and its INS, to know that it lies on its side. Owned by one behavior; time is the protocol clock.
class Kicker {
public:
    explicit Kicker(agent::BehaviorContext context);

    void hear(const protocol::InfoLine& line) { ball_.take(line, run_.now); }
    /// Once a tick, before the others.
    void perceive(const agent::Tick& tick);
    /// What the joints are to do now; nothing between two moves.
    std::optional<protocol::MultiDrive> walk();
    bool hasFallen() const { return fallen_; }
    /// It will be righted, and stands up anew.
    void standUpAgain() { gait_.reset(); }

    void order(agent::Order order) { run_.order(order); }
    void setParameters(const agent::ParameterSet& parameters) { settings_ = settingsFrom(parameters); }
    const Settings& settings() const { return settings_; }
    const std::string& state() const { return run_.state; }
    agent::BehaviorStatus status() const;
    const std::optional<Pose>& base_in_map() const { return base_in_map_; }
    const std::optional<agent::BehaviorFinished>& ending() const { return run_.ending; }
    std::vector<agent::BehaviorEvent> takeEvents() { return std::exchange(events_, {}); }

private:
    /// Where the ball is in the camera's picture: tangents, to the right and down of its middle.
    struct ImagePlace {
        double right = 0.0;
        double down = 0.0;
    };

    void lookForBall();
    void watchBalance(const modules::SensorModule& sensors);
    void watchClock();
    Strides strides();
    Strides circle();
    Strides steer(double turn_right) const;

    agent::TimedRun run_;
    Settings settings_;
    modules::SpecificSensor<protocol::BallReading> ball_;
    Gait gait_;

    std::optional<ImagePlace> seen_;
    Seconds lost_at_{0.0};
    bool last_on_the_right_ = false;
    double bow_rad_ = 0.0; ///< of the head, downward
    std::optional<Seconds> kicking_since_;
    int kicks_ = 0;

    std::optional<Pose> base_in_map_; ///< by the INS
    Vec2 way_from_m_ = Vec2::Zero();
    double way_m_ = 0.0;
    bool fallen_ = false;
    std::vector<agent::BehaviorEvent> events_;
};

} // namespace usar::ers
