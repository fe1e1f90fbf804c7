// A short flight: up, forward, down. The smallest behavior that has all that a behavior needs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/agent/behavior.h"

namespace usar::sample {

/// What a person can set; the window makes a form of it, and a mission file names them by `id`.
std::vector<agent::ParameterSpec> hopParameters();

/// Climbs to a height, flies some way forward, lands where it then is. Flies by the INS alone, in meters of its frame.
class Hop : public agent::Behavior {
public:
    explicit Hop(const agent::ParameterSet& parameters) : parameters_(parameters) {}

    void tick(const agent::Tick& tick, agent::CommandPort& port) override;
    void order(agent::Order order, agent::CommandPort& port) override;
    void setParameters(const agent::ParameterSet& parameters) override { parameters_ = parameters; }
    protocol::Command safeCommand() const override;

private:
    enum class State { Climb, Fly, Land, Done };

    protocol::AerialDrive decide(const Vec3& position_m, Seconds now);
    void tell(Seconds now, agent::CommandPort& port) const;
    const char* inWords() const;

    agent::ParameterSet parameters_;
    State state_ = State::Climb;
    bool paused_ = false;
    std::optional<Vec3> start_m_;
    std::optional<Seconds> started_;
    std::optional<Seconds> still_since_; ///< told to sink, and not sinking
    double lowest_m_ = 0.0;
    double flown_m_ = 0.0;
};

} // namespace usar::sample
