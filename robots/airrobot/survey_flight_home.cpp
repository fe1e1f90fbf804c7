// The way home of a survey, its landings, and its charges.
#include <algorithm>
#include <utility>

#include "core/base/numbers.h"
#include "robots/airrobot/survey_flight.h"
#include "robots/airrobot/verdict.h"

namespace usar::airrobot {

namespace {

constexpr double over_base_m = 0.8;
/// So many places to land may be no good before it takes one with less room, and then before it hovers and asks for
/// help.
constexpr std::size_t most_landing_places = 5;
constexpr double high_enough_m = 1.5; ///< to turn back from a landing

} // namespace

bool SurveyFlight::returning() const {
    return phase_ == Phase::Home || phase_ == Phase::Landing || (phase_ == Phase::Ground && errand_ != Errand::Start);
}

bool SurveyFlight::atBase() const {
    return landing() || (!door_m() && (home_m() - craft_.senses.position2_m()).norm() < over_base_m);
}

double SurveyFlight::batteryMargin() const {
    return craft_.battery.rangeLeft_m(beelineHome_m(), craft_.settings) / craft_.settings.battery_range_m;
}

bool SurveyFlight::robotBatteryLow() const {
    const WayHome way{beelineHome_m(), craft_.senses.heightOverGround_m(craft_.settings.maximum_height_m),
                      craft_.speedToward_m_s(home_m())};
    return isLow(craft_.senses.robot_battery, way, craft_.settings);
}

bool SurveyFlight::charged() const {
    const Seconds charging(errand_ == Errand::Start ? 0.0 : craft_.settings.recharge_time_s);
    return craft_.senses.now - sortie_.landed >= charging;
}

void SurveyFlight::goHome(Errand errand, const std::string& why, agent::CommandPort& port) {
    errand_ = errand;
    endPause("the robot has to go home", port);
    survey_.interrupt();
    craft_.startAnew();
    phase_ = Phase::Home;
    if (!why.empty())
        port.publish(agent::BehaviorEvent{Severity::Note, why});
}

void SurveyFlight::returnToCharge(agent::CommandPort& port) {
    craft_.log.mark(agent::MarkKind::Recharge, craft_.senses.position2_m(), craft_.senses, port);
    goHome(Errand::Recharge, "The battery's reserve is near; home for a charge.", port);
}

void SurveyFlight::abortScan(agent::CommandPort& port) {
    craft_.log.mark(agent::MarkKind::Recharge, craft_.senses.position2_m(), craft_.senses, port);
    end_reason_ = "The place to resume at is out of the battery's range; raise the range or move the base.";
    goHome(Errand::GivenUp, end_reason_, port);
}

void SurveyFlight::obeyRobotBattery(agent::CommandPort& port) {
    if (phase_ == Phase::Home)
        return;
    end_reason_ = "The robot's own battery runs out, and the simulator cannot charge it; raise its battery life.";
    goHome(Errand::GivenUp, end_reason_, port);
}

void SurveyFlight::landAt(const Vec2& near_m) {
    sortie_.landing_m = landingPlace_m(craft_.memory, near_m, craft_.settings.landing_radius_m,
                                       craft_.log.lean().slope(craft_.senses.base_in_map.yaw_rad));
    craft_.touchdown.start(sortie_.room);
    phase_ = Phase::Landing;
}

void SurveyFlight::landHere(agent::CommandPort& port) {
    if (!std::exchange(sortie_.looked_again, true)) { // What stood in the way may be gone, or was never there.
        craft_.ways.clear();
        return craft_.startAnew();
    }
    if (!std::exchange(sortie_.retraced, true) && !sortie_.refuge_m && craft_.retrace())
        return craft_.startAnew();
    end_reason_ = "The way home was blocked.";
    errand_ = Errand::GivenUp;
    if (sortie_.refuge_m) // No way leads there either.
        sortie_.refused_m.push_back(*sortie_.refuge_m);
    craft_.startAnew();
    if (sortie_.refused_m.size() <= most_landing_places && landNearby(craft_.dry_m(), port))
        return port.publish(agent::BehaviorEvent{Severity::Error,
                                                 "The way home is blocked; the robot lands on the nearest "
                                                 "ground that it has seen to be fit for it."});
    finish(false,
           "The way home is blocked, and no ground that is fit for landing can be reached. The robot hovers at " +
               placeWords(craft_.senses.position2_m()) + "; take over by hand.",
           port);
}

bool SurveyFlight::landNearby(double dry_m, agent::CommandPort& port) {
    const auto place_m = craft_.refuge.place_m(craft_.senses, craft_.memory, dry_m, sortie_.refused_m, sortie_.room);
    if (place_m)
        headFor(*place_m, port);
    return place_m.has_value();
}

void SurveyFlight::headFor(const Vec2& place_m, agent::CommandPort& port) {
    sortie_.refuge_m = place_m;
    sortie_.landing_m.reset();
    if ((place_m - craft_.senses.position2_m()).norm() <= craft_.settings.landing_radius_m)
        landAt(place_m);
    else
        goHome(errand_, "", port);
}

void SurveyFlight::landElsewhere(agent::CommandPort& port) {
    sortie_.refused_m.push_back(*sortie_.landing_m);
    if (sortie_.refused_m.size() <= most_landing_places && landNearby(craft_.dry_m(), port))
        return port.publish(agent::BehaviorEvent{
            Severity::Warning, "The robot cannot land where it was to land and goes to the next place."});
    if (std::exchange(sortie_.room, Room::Least) != Room::Least) {
        const Vec2 first_m = sortie_.refused_m.front(); // If that is the base, it has stood there.
        sortie_.refused_m.clear();
        craft_.memory.keepFresh(lately); // Scans that were placed wrong, from far aside, would block all ways.
        headFor(first_m, port);
        return port.publish(agent::BehaviorEvent{
            Severity::Warning, "No place has the usual room for a landing; the robot takes one with less."});
    }
    finish(false,
           "No place was found on which the robot can land. It hovers at " + placeWords(craft_.senses.position2_m()) +
               "; take over by hand.",
           port);
}

bool SurveyFlight::land(agent::CommandPort& port) {
    if (phase_ != Phase::Landing)
        return false; // It is on its way to another place.
    const bool judges = craft_.senses.heightOverGround_m(0.0) > high_enough_m &&
                        (*sortie_.landing_m - craft_.senses.position2_m()).norm() < over_base_m;
    const Descent descent = craft_.descend(*sortie_.landing_m, sortie_.refuge_m.has_value(), port);
    const bool unfit = sortie_.refuge_m && judges && craft_.touchdown.isUneven(craft_.senses); // The base is known.
    if (unfit || descent == Descent::KeptAway)
        landElsewhere(port);
    if (unfit || descent != Descent::Landed)
        return false;
    craft_.rest(port, "landed");
    craft_.log.mark(agent::MarkKind::Landing, craft_.senses.position2_m(), craft_.senses, port);
    craft_.log.goal(std::nullopt, port);
    phase_ = Phase::Ground;
    sortie_.at_work = false;
    sortie_.landed = craft_.senses.now;
    return true;
}

void SurveyFlight::recharge() {
    craft_.battery.recharge();
    had_lane_since_charge_ = false;
}

} // namespace usar::airrobot
