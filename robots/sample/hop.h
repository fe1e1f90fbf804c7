// A short flight: up, forward and down. This is the smallest behavior with everything that a behavior needs.
#pragma once

#include <optional>
#include <vector>

#include "core/agent/behavior.h"

namespace usar::sample {

/// The parameters that the user can set. The window shows them as a form; a mission file names them by `id`.
std::vector<agent::ParameterSpec> hopParameters();

/// Climbs to a height, flies a distance forward and lands there. Uses only the INS; positions are in meters in the map
/// frame.
class Hop : public agent::Behavior {
public:
    explicit Hop(const agent::ParameterSet& parameters) : parameters_(parameters) {}

    /// Sends one DRIVE and publishes pose and status; does nothing before the first INS reading and after the landing.
    void tick(const agent::Tick& tick, agent::CommandPort& port) override;
    /// Pause stops the robot at once, until Resume. LandNow also ends a pause.
    void order(agent::Order order, agent::CommandPort& port) override;
    void setParameters(const agent::ParameterSet& parameters) override { parameters_ = parameters; }
    /// Hovering. A robot keeps executing its last command, so this one is sent when the behavior is ended from outside.
    protocol::Command safeCommand() const override { return protocol::AerialDrive{0.0, 0.0, 0.0, 0.0}; }

private:
    /// The states follow one another in this order; none is repeated.
    enum class State { Climb, Fly, Land, Done };

    /// Updates the state and returns the command for this tick.
    protocol::AerialDrive decide(const Vec3& position_m, Seconds now);
    /// Publishes the status, and the end of the behavior once the robot has landed.
    void tell(Seconds now, agent::CommandPort& port) const;
    /// The state in words, for the user.
    const char* inWords() const;

    agent::ParameterSet parameters_;
    State state_ = State::Climb;
    bool paused_ = false;
    std::optional<Vec3> start_m_;        ///< position at the first tick with an INS reading
    std::optional<Seconds> started_;     ///< time of that tick
    std::optional<Seconds> still_since_; ///< since when the robot has not sunk, although commanded to
    double lowest_m_ = 0.0;              ///< height below which the robot must get to count as sinking
    double flown_m_ = 0.0;               ///< horizontal distance from the start
};

} // namespace usar::sample
