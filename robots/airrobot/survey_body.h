// The state that the senses and acts of a surveying AirRobot share: the flight and the current tick.
#pragma once

#include <functional>

#include "core/agent/posh_primitives.h"
#include "robots/airrobot/survey_flight.h"

namespace usar::airrobot {

/// Connects a SurveyFlight to a plan's engine: gives it ticks, orders and parameters, and passes on its commands and
/// published values as those of the act that caused them. Owned by one behavior, and used in its thread.
class SurveyBody final : public agent::PoshBody {
public:
    explicit SurveyBody(agent::BehaviorContext context) : flight_(std::move(context)) {}

    /// For senses, which cannot change anything.
    const SurveyFlight& flight() const { return flight_; }
    /// Calls `act` (a function or a member of SurveyFlight) as `act(flight)` or `act(flight, port)`, and passes on what
    /// the flight sends and publishes. Returns the result of `act`.
    template <class Act>
    auto with(const Act& act) {
        const Forward forward{*this};
        if constexpr (std::is_invocable_v<const Act&, SurveyFlight&>)
            return std::invoke(act, flight_);
        else
            return std::invoke(act, flight_, port_);
    }
    /// The current tick; valid only between begin and end.
    const agent::Tick& tick() const { return *tick_; }

    void onInfo(const protocol::InfoLine& line) override { flight_.hear(line); }
    /// Perceives and, in flight, looks along the leg, so that senses can be asked before the first act.
    void begin(const agent::Tick& tick) override;
    void end(const agent::Tick&) override {
        acting_ = false;
        tick_ = nullptr;
    }
    /// The flight handles every order. What it publishes reaches the engine with the next tick.
    bool order(agent::Order order) override;
    void setParameters(const agent::ParameterSet& parameters) override { flight_.setParameters(parameters); }
    void describe(agent::BehaviorStatus& status) const override { status = flight_.status(); }
    std::optional<agent::BehaviorFinished> ended() const override { return flight_.ending(); }
    protocol::Command safeCommand() const override { return flight_.craft().still(); }

private:
    /// Passes on what the flight sent and published when the act that caused it returns.
    struct Forward {
        SurveyBody& body;
        ~Forward() { body.passOn(); }
    };
    /// Moves the commands and published values from `port_` to the engine.
    void passOn();
    /// Writes phase, lane and goal to the plan's blackboard.
    void noteState();

    SurveyFlight flight_;
    agent::CommandPort port_; ///< emptied after each act; the output of an order stays here until the next tick
    const agent::Tick* tick_ = nullptr; ///< nullptr outside of ticks
    bool acting_ = false;               ///< acts are running, so the state is written to the blackboard
};

/// All senses and acts.
agent::PoshRegistry surveyPrimitives();

} // namespace usar::airrobot
