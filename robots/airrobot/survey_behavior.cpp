#include "robots/airrobot/survey_behavior.h"

namespace usar::airrobot {

protocol::Command SurveyBehavior::safeCommand() const {
    return protocol::AerialDrive{0.0, 0.0, 0.0, 0.0};
}

void SurveyBehavior::tick(const agent::Tick& tick, agent::CommandPort& port) {
    if (flight_.finished())
        return;
    flight_.perceive(tick, port);
    if (flight_.phase() == Phase::Launch)
        launch(tick, port);
    else if (flight_.sensorsSilent() && flight_.phase() != Phase::Ground)
        flight_.awaitSensors(port);
    else
        act(tick, port);
    publishEnd(port);
}

void SurveyBehavior::publishEnd(agent::CommandPort& port) {
    port.publish(flight_.status());
    if (flight_.ending())
        port.publish(*flight_.ending());
}

void SurveyBehavior::order(agent::Order order, agent::CommandPort& port) {
    if (flight_.finished())
        return;
    flight_.order(order, port);
    if (flight_.ending())
        port.publish(*flight_.ending());
}

void SurveyBehavior::launch(const agent::Tick& tick, agent::CommandPort& port) {
    if (flight_.checkLaunch(tick, port) != LaunchState::Ready)
        return;
    flight_.planSurvey(port);
    flight_.beginReset();
}

void SurveyBehavior::act(const agent::Tick& tick, agent::CommandPort& port) {
    watchBattery(port);
    const Phase phase = flight_.phase();
    if (flight_.paused() && phase != Phase::Landing && phase != Phase::Ground)
        return flight_.holdPlace(port);
    switch (phase) {
    case Phase::TakeOff:
        if (flight_.climb(flight_.craft().settings.scan_altitude_m, port))
            flight_.beginWork();
        return;
    case Phase::ToLane:
    case Phase::Lane:
        return survey(port);
    case Phase::Home:
        return flyHome(port);
    case Phase::Landing:
        if (flight_.land(port))
            flight_.beginReset();
        return;
    case Phase::Ground:
        return onGround(tick, port);
    case Phase::Launch:
    case Phase::Finished:
        return;
    }
}

void SurveyBehavior::watchBattery(agent::CommandPort& port) {
    if (flight_.phase() == Phase::Ground || flight_.phase() == Phase::Landing)
        return;
    if (flight_.robotBatteryLow())
        flight_.obeyRobotBattery(port);
    if (flight_.phase() != Phase::ToLane && flight_.phase() != Phase::Lane)
        return;
    if (flight_.batteryMargin() > 0.0)
        return;
    if (flight_.resumedGoalReached())
        flight_.returnToCharge(port);
    else
        flight_.abortScan(port);
}

void SurveyBehavior::survey(agent::CommandPort& port) {
    if (flight_.goalReached())
        flight_.nextGoal(port);
    if (!flight_.returning() && flight_.fly(port) == FlightState::Unreachable)
        flight_.skipGoal(port);
}

void SurveyBehavior::flyHome(agent::CommandPort& port) {
    if (flight_.atBase())
        flight_.beginLanding();
    else if (flight_.fly(port) == FlightState::Unreachable)
        flight_.landHere(port);
}

void SurveyBehavior::onGround(const agent::Tick& tick, agent::CommandPort& port) {
    if (flight_.scanOver())
        return flight_.conclude(port);
    const ResetState reset = flight_.stepReset(tick, port);
    const bool settled = reset == ResetState::Done || reset == ResetState::Failed;
    if (!settled || flight_.paused() || !flight_.charged())
        return;
    if (flight_.returning())
        flight_.recharge();
    flight_.setOut();
}

} // namespace usar::airrobot
