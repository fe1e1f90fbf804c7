// A Submarine that follows the bottom of the sea: perception and decisions.
#pragma once

#include <optional>

#include "core/agent/timed_behavior.h"
#include "core/modules/queued_sensor.h"
#include "robots/submarine/dead_reckoning.h"
#include "robots/submarine/level_rule.h"
#include "robots/submarine/limits.h"

namespace usar::submarine {

/// The thesis's robot (3.5.1) has one ray on its belly, a rudder, planes and a propeller. Either it corrects its height
/// with the planes, or it is level and turns with the rudder. Beyond the thesis, it estimates from its own rudder,
/// planes and propeller the pitch of its hull, the slope of the bottom and the places where it could follow the bottom.
/// It returns to such a place from a coast, from shallows, and where the bottom falls out of reach. It cannot see a
/// wall in front of its nose. Owned by one behavior; times are those of the protocol clock.
class Diver : public agent::TimedDecider<Settings> {
public:
    using TimedDecider::TimedDecider;

    /// Keeps every reading of the ray until the next tick, because several can come between two ticks.
    void hear(const protocol::InfoLine& line) { readings_.take(line, run_.now); }
    /// Evaluates the readings. Call it once per tick, before `decide`. `limits` is nullopt while the robot is still
    /// being asked for them.
    void perceive(const agent::Tick& tick, const std::optional<Limits>& limits);
    /// Returns the command for this tick; it brakes while the limits are unknown.
    protocol::NauticDrive decide();

    /// The state includes the height over the bottom if it is known. The distance is estimated.
    agent::BehaviorStatus status() const;

private:
    /// BackingOff moves backward from a bottom that is too near. GoingBack steers to a place where the robot could
    /// follow the bottom.
    enum class Maneuver { None, BackingOff, GoingBack };

    /// Advances hull and trail by the newest fin angles of STA and the propeller speed that was commanded last.
    void reckon(Seconds dt, const modules::StateModule& state);
    /// Takes the queued readings in order. A range near the reach counts as no echo; zero, negative and NaN are
    /// skipped.
    void takeReadings();
    /// Tells the user once when the ray falls silent.
    void watchRay();
    /// Ends the behavior if the robot has sunk too far without an echo.
    void watchSearch(Seconds dt);
    /// Begins and ends maneuvers; without `knows_slant` there is only BackingOff.
    void stepManeuver();
    void begin(Maneuver maneuver);
    /// Continues without a maneuver if no place to return to is known.
    void beginGoingBack();
    /// Estimates the rise of the bottom from the last two echoes and the robot's own climb.
    void reckonBottom();
    /// Measures how long the robot has been too low or too high, and remembers places where it was neither.
    void watchLevel();
    /// True if no reading has come for `blind_after`; the robot then waits.
    bool blind() const { return run_.now - heard_at_ > blind_after; }
    /// True if the bottom is too near, or will be soon at the present speed.
    bool inDanger() const;
    /// Whether the planes have not brought the robot down for a long time, as at the surface.
    bool divesInVain() const;
    /// Angle of the stern planes that leads to the wanted height.
    double plane_rad() const;
    /// The side to turn to: 1 for right, -1 for left.
    double side() const;
    /// Brakes with the propeller, because the hull would otherwise glide on for twenty meters.
    protocol::NauticDrive halt(const char* state);
    protocol::NauticDrive keepLevel();
    protocol::NauticDrive backOff();
    protocol::NauticDrive goBack();
    /// `share` is that of the propeller in the settings, and `rudder_share` is positive to the right; the plane is
    /// limited to what it can do.
    protocol::NauticDrive drive(double share, double rudder_share, double plane_rad, const char* state);

    static constexpr Seconds blind_after{2.0};
    static constexpr double unknown_m = 1e9;

    std::optional<Limits> limits_;
    modules::QueuedSensorModule readings_;
    PitchModel hull_;
    Trail trail_;
    Echoes echoes_;  ///< lengths of the ray
    Echoes heights_; ///< heights over the bottom, corrected for the pitch if the robot knows it
    double pitch_at_echo_rad_ = 0.0;
    double rise_now_m_s_ = 0.0;    ///< rate at which the bottom under the moving robot rises, from the last two echoes
    double bottom_rise_m_s_ = 0.0; ///< the same, smoothed

    Seconds heard_at_{-1e9};  ///< time of the tick that took the last reading
    Seconds reading_at_{0.0}; ///< time of the last reading itself
    Maneuver maneuver_ = Maneuver::None;
    double maneuver_began_m_ = 0.0;     ///< value of way_m_ when the maneuver began
    std::optional<Vec2> back_to_m_;     ///< destination of GoingBack, in the frame of the trail
    Seconds below_since_{0.0};          ///< since when the robot has been too low
    Seconds above_since_{0.0};          ///< since when it has been too high without coming down
    double came_down_to_m_ = unknown_m; ///< height over the bottom when above_since_ was set
    double searched_m_ = 0.0;           ///< distance that the robot has sunk since the last echo
    double way_m_ = 0.0;                ///< estimated distance traveled
    double propeller_share_ = 0.0;      ///< commanded speed as a share of the greatest
    double plane_now_rad_ = 0.0;        ///< angle of the stern planes in the newest STA

    bool blind_told_ = false;
};

} // namespace usar::submarine
