// The behavior "airrobot/cpp": the terrain survey of the thesis's chapter 4 as a state machine.
#pragma once

#include <utility>

#include "core/agent/robot_plugin.h"
#include "robots/airrobot/survey_flight.h"

namespace usar::airrobot {

/// Goes through launch checklist, INS reset (which also gives the INS its rest before the start), take-off and lanes.
/// Returns home for a charge, after each quadrant and at the end; resets the INS and recharges on the ground; then
/// resumes where it stopped. In every tick it checks, in the order of the thesis's drive collection: silent sensors,
/// battery, stuck, sonars, goal.
class SurveyBehavior : public agent::Behavior {
public:
    explicit SurveyBehavior(agent::BehaviorContext context) : flight_(std::move(context)) {}

    void tick(const agent::Tick& tick, agent::CommandPort& port) override;
    void order(agent::Order order, agent::CommandPort& port) override;
    void setParameters(const agent::ParameterSet& parameters) override { flight_.setParameters(parameters); }
    protocol::Command safeCommand() const override;

    Phase phase() const { return flight_.phase(); }

private:
    /// Publishes the status and, once the flight has ended, how it ended.
    void publishEnd(agent::CommandPort& port);
    void launch(const agent::Tick& tick, agent::CommandPort& port);
    void act(const agent::Tick& tick, agent::CommandPort& port);
    /// Sends the robot home if a battery runs low.
    void watchBattery(agent::CommandPort& port);
    void survey(agent::CommandPort& port);
    void flyHome(agent::CommandPort& port);
    void onGround(const agent::Tick& tick, agent::CommandPort& port);

    SurveyFlight flight_;
};

} // namespace usar::airrobot
