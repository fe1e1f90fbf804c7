// A Submarine along the bottom of the sea: what it knows, and what it makes of it.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/agent/robot_plugin.h"
#include "core/agent/timed_run.h"
#include "core/modules/queued_sensor.h"
#include "robots/submarine/level_rule.h"
#include "robots/submarine/limits.h"
#include "robots/submarine/trail.h"

namespace usar::submarine {

/// The thesis's robot (3.5.1): one ray on its belly, a rudder, planes and a propeller. Either it corrects its height by
/// the planes, or it is level and turns by the rudder. What the thesis's robot does not know it reckons from its own
/// fins: how its hull lies, how the bottom rises, and where it could follow that. From a coast, from shallows and from
/// where the bottom falls out of reach it goes back there. What rises like a wall before its nose no ray of its shows.
/// Owned by one behavior; time is the protocol clock.
class Diver {
public:
    explicit Diver(agent::BehaviorContext context);

    /// Keeps every reading of the ray until the next tick: its last and present value may come between two of them.
    void hear(const protocol::InfoLine& line) { readings_.take(line, run_.now); }
    /// Once a tick, before `decide`. `limits`: nothing while they are being asked for.
    void perceive(const agent::Tick& tick, const std::optional<Limits>& limits);
    protocol::NauticDrive decide();

    void order(agent::Order order) { run_.order(order); }
    void setParameters(const agent::ParameterSet& parameters) { settings_ = settingsFrom(parameters); }
    const Settings& settings() const { return settings_; }
    const std::string& state() const { return run_.state; }
    agent::BehaviorStatus status() const;
    const std::optional<agent::BehaviorFinished>& ending() const { return run_.ending; }
    std::vector<agent::BehaviorEvent> takeEvents() { return std::exchange(events_, {}); }

private:
    enum class Maneuver { None, BackingOff, GoingBack };

    void reckon(Seconds dt, const modules::StateModule& state);
    void takeReadings();
    void watchRay();
    void watchSearch(Seconds dt);
    void watchClock();
    void stepManeuver();
    void begin(Maneuver maneuver);
    void beginGoingBack();
    void reckonBottom();
    void watchLevel();
    bool blind() const { return run_.now - heard_at_ > blind_after; }
    bool inDanger() const;
    bool divesInVain() const;
    double plane_rad() const;
    double side() const;
    protocol::NauticDrive halt(const char* state);
    protocol::NauticDrive keepLevel();
    protocol::NauticDrive backOff();
    protocol::NauticDrive goBack();
    protocol::NauticDrive drive(double share, double rudder_share, double plane_rad, const std::string& state);

    static constexpr Seconds blind_after{2.0};
    static constexpr double unknown_m = 1e9;

    agent::TimedRun run_;
    Settings settings_;
    std::optional<Limits> limits_;
    modules::QueuedSensorModule readings_;
    PitchModel hull_;
    Trail trail_;
    Echoes echoes_;  ///< as the ray has them
    Echoes heights_; ///< as the rule takes them
    double pitch_at_echo_rad_ = 0.0;
    double rise_now_m_s_ = 0.0;    ///< of the bottom under the robot on its way, by the last two echoes
    double bottom_rise_m_s_ = 0.0; ///< smoothed

    Seconds heard_at_{-1e9};
    Seconds reading_at_{0.0};
    Maneuver maneuver_ = Maneuver::None;
    double maneuver_began_m_ = 0.0; ///< of the way
    std::optional<Vec2> back_to_m_;
    Seconds below_since_{0.0};
    Seconds above_since_{0.0};
    double came_down_to_m_ = unknown_m; ///< over the bottom, in that time
    double searched_m_ = 0.0;           ///< downward, since the last echo
    double way_m_ = 0.0;
    double propeller_share_ = 0.0; ///< as told
    double plane_now_rad_ = 0.0;   ///< as STA has it

    bool blind_told_ = false;
    std::vector<agent::BehaviorEvent> events_;
};

} // namespace usar::submarine
