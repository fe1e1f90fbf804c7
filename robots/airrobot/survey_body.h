// What the senses and acts of an AirRobot on a survey share: the flight, and the tick that it is in.
#pragma once

#include "core/agent/posh_registry.h"
#include "robots/airrobot/survey_flight.h"

namespace usar::airrobot {

/// Owned by one behavior.
class SurveyBody final : public agent::PoshBody {
public:
    explicit SurveyBody(agent::BehaviorContext context) : flight_(std::move(context)) {}

    const SurveyFlight& flight() const { return flight_; }
    /// Has the flight do something: `act(flight, port)`.
    template <class Act>
    auto with(Act&& act) {
        const Forward forward(*this);
        return act(flight_, port_);
    }
    const agent::Tick& tick() const { return *tick_; }

    void begin(const agent::Tick& tick) override;
    void end(const agent::Tick&) override;
    bool order(agent::Order order) override;
    void setParameters(const agent::ParameterSet& parameters) override { flight_.setParameters(parameters); }
    void describe(agent::BehaviorStatus& status) const override { status = flight_.status(); }
    std::optional<agent::BehaviorFinished> ended() const override { return flight_.ending(); }
    protocol::Command safeCommand() const override { return protocol::AerialDrive{0.0, 0.0, 0.0, 0.0}; }

private:
    /// Passes on what the flight sent and published, at the place of the act that had it do so.
    struct Forward {
        explicit Forward(SurveyBody& owner) : body(owner) {}
        ~Forward() { body.passOn(); }
        Forward(const Forward&) = delete;
        Forward& operator=(const Forward&) = delete;
        SurveyBody& body;
    };
    void passOn();
    void noteState();

    SurveyFlight flight_;
    agent::CommandPort port_; ///< emptied after each act; what an order said waits here for the next tick
    const agent::Tick* tick_ = nullptr;
    bool acting_ = false; ///< acts are at work, and what is written is traced
};

using SurveyPrimitives = agent::PoshPrimitives<SurveyBody>;

void addSurveySenses(SurveyPrimitives& primitives);
void addSurveyActs(SurveyPrimitives& primitives);

} // namespace usar::airrobot
