// An ERS that looks for a ball and kicks it: perception and decisions.
#pragma once

#include <optional>

#include "core/agent/timed_behavior.h"
#include "core/modules/specific_sensor.h"
#include "robots/ers/gait.h"
#include "robots/ers/settings.h"

namespace usar::ers {

/// The thesis's robot (3.5.2). Of its many sensors it uses only the ball finder, through the module for a specific
/// sensor, and the INS, to notice that it lies on its side. Walks in circles until it sees the ball, walks to it, and
/// kicks it by walking on. Owned by one behavior; times are those of the protocol clock.
class Kicker : public agent::TimedDecider<Settings> {
public:
    using TimedDecider::TimedDecider;

    /// Keeps the newest reading of the ball finder. It counts for half a second.
    void hear(const protocol::InfoLine& line) { ball_.take(line, run_.now); }
    /// Evaluates the newest readings. Call it once per tick, before the other functions.
    void perceive(const agent::Tick& tick);
    /// Returns the joint targets for this tick; nullopt between two moves of the gait.
    std::optional<protocol::MultiDrive> walk();
    /// Whether the robot lies on its side, nose or back: its roll or pitch exceeds 1.1 rad.
    bool hasFallen() const { return fallen_; }
    /// Makes the gait start with standing up, because the robot is about to be righted.
    void standUpAgain() { gait_.reset(); }

    /// The distance is horizontal, from the INS, without swaying.
    agent::BehaviorStatus status() const { return run_.status(Seconds(settings_.play_time_s), way_m_); }
    /// The newest pose from the INS; nullopt before the first reading.
    const std::optional<Pose>& base_in_map() const { return base_in_map_; }

private:
    /// The place of the ball in the camera's picture, as tangents of the angles to the right of and below its middle.
    struct ImagePlace {
        double right = 0.0;
        double down = 0.0;
    };

    /// Updates `seen_` and the head's angle. A near ball that leaves the picture begins a kick.
    void lookForBall();
    /// Warns once when the robot falls, and adds up the distance walked without swaying.
    void watchBalance(const modules::SensorModule& sensors);
    /// The strides for what the robot sees; also sets the state in words.
    Strides strides();
    /// Walks toward the side where the ball was last seen. Tight and wide circles alternate.
    Strides circle();
    /// `turn_right`: -1..1; greater values count as these. Paws on the inner side take shorter steps or step backward.
    Strides steer(double turn_right) const;

    modules::SpecificSensor<protocol::BallReading> ball_;
    Gait gait_;

    std::optional<ImagePlace> seen_; ///< nullopt while the ball is not visible
    Seconds lost_at_{0.0};           ///< time at which the ball was last lost, or of the start
    bool last_on_the_right_ = false; ///< side of the picture on which the ball was last seen
    double bow_rad_ = 0.0;           ///< angle of the head, positive downward
    /// Time at which a near ball left the picture; nullopt once a ball is seen.
    std::optional<Seconds> kicking_since_;
    /// Number of times that the ball was at the paws; it is part of the result.
    int kicks_ = 0;

    std::optional<Pose> base_in_map_; ///< from the INS
    Vec2 way_from_m_ = Vec2::Zero();  ///< position up to which way_m_ counts
    double way_m_ = 0.0;              ///< distance walked
    bool fallen_ = false;
};

} // namespace usar::ers
