#include "robots/airrobot/survey_flight.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/numbers.h"
#include "robots/airrobot/outlook.h"
#include "robots/airrobot/verdict.h"

namespace usar::airrobot {

namespace {

constexpr double near_base_m = 2.5; ///< A way that leads so near to the base leads home.
constexpr Seconds lost_after{15.0};
constexpr Seconds time_to_land{45.0}; ///< with the way to the nearest place, without the descent
/// A take-off may take this long, and in addition twice the time of a careful climb, because of the looks on its way.
constexpr Seconds spare_for_take_off{60.0};
constexpr double off_the_ground_m = 1.0;
/// A robot between these distances from its start pose was spawned there because the start pose was occupied; a robot
/// farther away was flown there.
constexpr double beside_start_m = 1.0;
constexpr double away_from_start_m = 6.0;

/// Names the silent sonars: "sonars" if all are silent, otherwise "sonar L4" or "sonars L4, L3".
std::string silentSonars(const Senses& senses) {
    if (senses.sonars.empty())
        return "sonars";
    std::string names;
    for (const std::string& name : senses.silent_sonars)
        names += (names.empty() ? " " : ", ") + name;
    return (senses.silent_sonars.size() == 1 ? "sonar" : "sonars") + names;
}

Seconds longestSilence(const Senses& senses) {
    return std::max({senses.ins_age, senses.sonar_age, senses.scan_age});
}

/// `first`: before the first take-off.
Stage stageOf(Phase phase, bool first) {
    switch (phase) {
    case Phase::Lane:
        return Stage::Lane;
    case Phase::ToLane:
    case Phase::Home:
        return Stage::Way;
    case Phase::Landing:
        return Stage::Landing;
    case Phase::Ground:
    case Phase::TakeOff:
        return first ? Stage::None : Stage::Charge;
    case Phase::Launch:
    case Phase::Finished:
        break;
    }
    return Stage::None;
}

} // namespace

SurveyFlight::SurveyFlight(agent::BehaviorContext context)
    : task_(std::move(context.task))
    , base_in_map_(task_.start_in_map)
    , start_z_m_(task_.start_in_map.position_m.z()) {
    setParameters(context.parameters);
}

void SurveyFlight::setParameters(const agent::ParameterSet& parameters) {
    craft_.settings = Settings::parameters.settings(parameters).asAsked();
    chooses_floor_ = craft_.settings.floor_level_m == Settings::chosen_floor_m;
    putFloor();
}

/// No water is higher than a dry start, and the scanner looks through water, so nothing lower than the start is safe
/// unless somebody knows where the water is.
void SurveyFlight::putFloor() {
    if (chooses_floor_)
        craft_.settings.floor_level_m = task_.dry_above_m.value_or(start_z_m_) + craft_.settings.clearance_m;
}

bool SurveyFlight::inTheAir() const {
    return phase_ != Phase::Launch && phase_ != Phase::Ground && phase_ != Phase::Finished;
}

bool SurveyFlight::goalReached() const {
    const bool in_the_open = !craft_.avoiding() && !craft_.overhead.hasCeiling();
    return survey_.goalReached(craft_.senses.position2_m(), craft_.settings, in_the_open);
}

void SurveyFlight::perceive(const agent::Tick& tick, agent::CommandPort& port) {
    if (!started_)
        started_ = tick.now;
    craft_.perceive(tick, checklist_.layout(), inTheAir(), port);
    noteCeiling(port);
    if (inTheAir() && craft_.crash())
        finish(false,
               "The robot has crashed at " + placeWords(craft_.senses.position2_m()) + ": " + craft_.crash() + ".",
               port);
    goal_distance_m_.reset();
    if (phase_ != Phase::Launch)
        noteSilence(port);
    const double height_m = craft_.senses.heightOverGround_m(craft_.settings.maximum_height_m);
    if (inTheAir() && phase_ != Phase::Landing && !silent_ && robotBatteryLow())
        endPause("the robot's own battery runs out", port);
    if (phase_ == Phase::Home && !silent_ && !sortie_.refuge_m && craft_.senses.robot_battery &&
        *craft_.senses.robot_battery < time_to_land + Seconds(height_m / craft_.settings.descent_speed_m_s) &&
        landNearby(craft_.dry_m(), port))
        port.publish(agent::BehaviorEvent{Severity::Error,
                                          "The robot's own battery is nearly empty; the robot lands on "
                                          "the nearest ground that it has seen to be fit for it."});
    ledger_.note(craft_.senses, phase_ == Phase::Lane, craft_.scanned);
    if (phase_ == Phase::ToLane || phase_ == Phase::Lane)
        survey_.note(craft_.senses.position2_m());
    if (leftovers_.passDoor(craft_, survey_, phase_ == Phase::Home, port)) {
        showPlan(port);
        riseBeyondDoor();
    }
    time_.note({tick.now, stageOf(phase_, errand_ == Errand::Start), phase_ == Phase::Home, paused_ || silent_,
                craft_.senses.position2_m(), survey_.doneLength_m(), craft_.battery.flown_m()},
               craft_.settings);
    if (planned() && !finished())
        time_.update(tick.now, survey_, missionState(), craft_.settings);
    if ((phase_ == Phase::ToLane || phase_ == Phase::Lane) && !silent_ && time_.overdue()) {
        end_reason_ = "The survey took far longer than was to be expected and was not done.";
        while (leftovers_.begun() && !survey_.done()) // The rest of it counts as not scanned.
            survey_.giveUp(craft_.settings, LeftOut::Late);
        goHome(leftovers_.begun() ? Errand::Done : Errand::GivenUp, "The survey takes too long; the robot goes home.",
               port);
    }
}

void SurveyFlight::noteSilence(agent::CommandPort& port) {
    const Senses& senses = craft_.senses;
    const Seconds worst = longestSilence(senses);
    const bool silent = worst > Seconds(craft_.settings.sensor_timeout_s);
    if (silent && !silent_) {
        const std::string which = worst == senses.ins_age ? (craft_.settings.navigate_by_truth ? "ground truth" : "INS")
                                  : worst == senses.sonar_age ? silentSonars(senses)
                                                              : "range scanner";
        port.publish(agent::BehaviorEvent{Severity::Error,
                                          "The " + which + " went silent; the robot waits for data where it is."});
    }
    if (silent_ && !silent)
        port.publish(agent::BehaviorEvent{Severity::Note, "All sensors speak again."});
    silent_ = silent;
}

void SurveyFlight::awaitSensors(agent::CommandPort& port) {
    craft_.brace(port, "sensors silent");
    if (longestSilence(craft_.senses) > lost_after)
        finish(false, "A sensor that the flight needs stays silent; the robot hovers. Take over by hand.", port);
}

LaunchState SurveyFlight::checkLaunch(const agent::Tick& tick, agent::CommandPort& port) {
    const LaunchState state = checklist_.step(tick.now, tick.robot, port);
    if (state == LaunchState::Failed)
        finish(false, checklist_.words() + ".", port, checklist_.missing());
    return state;
}

void SurveyFlight::planSurvey(agent::CommandPort& port) {
    const auto planned = Survey::make(task_, craft_.settings);
    if (!planned)
        return finish(false, planned.error().text(), port);
    survey_ = *planned;
    ledger_ = ScanLedger(task_.area_in_map);
    showPlan(port);
    const Outlook outlook = outlookOf(survey_, task_.start_in_map.position_m.head<2>(), craft_.settings);
    port.publish(agent::BehaviorEvent{Severity::Note, outlookWords(outlook.range)});
    if (craft_.settings.navigate_by_truth)
        port.publish(agent::BehaviorEvent{Severity::Note, "The robot navigates by ground truth, as no real robot can; "
                                                          "its map says nothing about drift."});
    phase_ = Phase::Ground;
}

bool SurveyFlight::stepReset(const agent::Tick& tick, agent::CommandPort& port) {
    if (craft_.settings.navigate_by_truth)
        return true; // There is nothing to set.
    const ResetState before = ins_reset_.state();
    const ResetState reset = ins_reset_.step(tick.now, tick.robot, port, craft_.settings);
    if (reset != before && reset == ResetState::Failed)
        port.publish(agent::BehaviorEvent{
            Severity::Warning, scanOver()
                                   ? "The INS could not be set; how far it drifted in the last flight stays unknown."
                                   : "The INS could not be set; the flight goes on with its drift."});
    if (reset != before && reset == ResetState::Done)
        port.publish(agent::BehaviorEvent{Severity::Note, "The INS was set from ground truth."});
    // At the end, one more estimate has to show the setting to whoever makes the map.
    return (reset == ResetState::Done || reset == ResetState::Failed) && (!scanOver() || reset == before);
}

void SurveyFlight::showPlan(agent::CommandPort& port) const {
    port.publish(agent::PlannedPath{survey_.path_m(base_in_map_.position_m.head<2>(), craft_.settings)});
}

void SurveyFlight::replan(agent::CommandPort& port) {
    // In a room, ways between lanes lead around walls, of which the plan knows nothing.
    if (errand_ == Errand::Start || craft_.overhead.hasCeiling() || !craft_.mayClimb())
        return;
    const Vec2 base_m = base_in_map_.position_m.head<2>();
    const double detour = time_.detour();
    Survey::Choice choose;
    if (Leftovers::crosses(craft_, survey_))
        choose = [&](const std::vector<mapping::Lane>& flown) {
            return leftovers_.chosenAnew(craft_, survey_, ledger_, base_m, flown, detour);
        };
    const bool changed = survey_.replan(ledger_, base_m, craft_.settings, detour, choose);
    showPlan(port); // Its flights home may be others even if its lanes are the same.
    if (!changed)
        return;
    const std::size_t left = survey_.laneCount() - survey_.laneIndex();
    port.publish(agent::BehaviorEvent{Severity::Note, "What is left is planned anew: " + std::to_string(left) +
                                                          (left == 1 ? " lane." : " lanes.")});
}

void SurveyFlight::setOut(agent::CommandPort& port) {
    replan(port);
    if (survey_.done() && !leftovers_.addLanes(craft_, survey_, ledger_, base_in_map_.position_m.head<2>(), port)) {
        errand_ = Errand::Done;
        return conclude(port);
    }
    craft_.forgetPlaces();
    leftovers_.startAnew();
    phase_ = Phase::TakeOff;
    launched_ = true;
    sortie_ = {};
}

bool SurveyFlight::climb(double altitude_m, agent::CommandPort& port) {
    if (!sortie_.take_off_m) {
        sortie_.take_off_m = craft_.senses.position_m(); // Not earlier, because the INS was set only a tick ago
        sortie_.took_off = craft_.senses.now;
        const double aside_m = (*sortie_.take_off_m - task_.start_in_map.position_m).norm();
        if (errand_ == Errand::Start && aside_m > beside_start_m && aside_m < away_from_start_m)
            base_in_map_ = craft_.senses.base_in_map;
        if (errand_ == Errand::Start)
            chooseFloor(port);
    }
    const Vec2 over_m = sortie_.take_off_m->head<2>();
    double goal_z_m = std::max(sortie_.take_off_m->z() + altitude_m, craft_.settings.floor_level_m);
    if (sortie_.beyond_door) // It is as high there as it can be, because racks may stand beside it.
        goal_z_m = std::min(goal_z_m, craft_.overhead.limit_m(over_m));
    if (craft_.rise(goal_z_m, over_m, port)) {
        const auto& column_m = craft_.column_m();
        if (column_m && !sortie_.beyond_door && canLand(craft_.memory, *column_m, craft_.dry_m()))
            base_in_map_.position_m.head<2>() = *column_m;
        return true;
    }
    const Seconds longest = spare_for_take_off + Seconds(2.0 * altitude_m / carefulClimb_m_s(craft_.settings));
    if (craft_.senses.now - sortie_.took_off < longest / craft_.senses.steadyShare())
        return false;
    const double risen_m = craft_.senses.position_m().z() - sortie_.take_off_m->z();
    if (risen_m > off_the_ground_m) {
        port.publish(agent::BehaviorEvent{Severity::Warning, "The robot does not get higher than " + fixed(risen_m, 1) +
                                                                 " m above its start and flies on at this height."});
        return true;
    }
    finish(false,
           "The robot does not leave the ground: it was told to climb for " + fixed(longest.count(), 0) +
               " s. Is something on it, or is its battery empty?",
           port);
    return false;
}

void SurveyFlight::riseBeyondDoor() {
    sortie_.take_off_m = craft_.senses.position_m();
    sortie_.took_off = craft_.senses.now;
    sortie_.at_work = false;
    sortie_.beyond_door = true;
    sortie_.rises_homeward = phase_ == Phase::Home || phase_ == Phase::Landing;
    sortie_.landing_m.reset(); // It chooses a place once it is up; a plan would wait for that landing before it rises.
    phase_ = Phase::TakeOff;
}

void SurveyFlight::chooseFloor(agent::CommandPort& port) {
    start_z_m_ = sortie_.take_off_m->z();
    putFloor();
    if (!chooses_floor_)
        return;
    const Settings& settings = craft_.settings;
    std::string words = "No floor level is set, so the robot stays above " + fixed(settings.floor_level_m, 1) +
                        " m, which is " + fixed(settings.clearance_m, 1) + " m above ";
    words += task_.dry_above_m ? "the level that the world's water does not exceed."
                               : "its start. Set one if there is dry ground farther down.";
    port.publish(agent::BehaviorEvent{Severity::Note, words});
}

/// Moves the lanes, because a robot that leans scans what is beside it.
void SurveyFlight::shiftLanes() {
    survey_.shift(-craft_.log.lean().scanAside_m(craft_.senses.base_in_map.yaw_rad, craft_.settings.scan_altitude_m));
}

void SurveyFlight::beginWork() {
    phase_ = sortie_.rises_homeward ? Phase::Home : Phase::ToLane;
    sortie_.at_work = true;
    shiftLanes();
    craft_.startAnew();
}

Leg SurveyFlight::leg() const {
    const Settings& settings = craft_.settings;
    if (returning()) {
        const Vec2 to_m = door_m().value_or(home_m());
        return {to_m, to_m, settings.transit_speed_m_s, words(), Width::Least};
    }
    if (survey_.done())
        return {craft_.senses.position2_m(), craft_.senses.position2_m(), settings.transit_speed_m_s, words()};
    return {survey_.goal_m(settings),
            survey_.aim_m(craft_.senses.position2_m(), settings),
            survey_.onLane() ? settings.scan_speed_m_s : settings.transit_speed_m_s,
            words(),
            craft_.narrowest(),
            survey_.onLane() ? std::optional(survey_.laneEnd_m()) : std::nullopt};
}

Leg SurveyFlight::takeLeg() {
    if (!returning()) {
        phase_ = survey_.onLane() ? Phase::Lane : Phase::ToLane;
        had_lane_since_charge_ = had_lane_since_charge_ || phase_ == Phase::Lane;
    }
    const Leg next = leg();
    goal_distance_m_ = (next.goal_m - craft_.senses.position2_m()).norm();
    return next;
}

/// A map in which no way leads home is wrong, because the robot came from there.
bool SurveyFlight::doubtsMap(const ReachablePlaces& reach) {
    const bool came_straight = !sortie_.beyond_door && !craft_.ways.isUnder();
    return came_straight && !reach.leadsNear(base_in_map_.position_m.head<2>(), near_base_m) &&
           !std::exchange(sortie_.doubted_map, true);
}

void SurveyFlight::skipGoal(agent::CommandPort& port) {
    const bool cut_off = craft_.walledOff();
    const bool room = !craft_.mayClimb();
    const ReachablePlaces reach = cut_off ? craft_.ways.reach(craft_.senses, craft_.narrowest()) : ReachablePlaces();
    if (cut_off && doubtsMap(reach)) {
        craft_.ways.clear();
        return craft_.startAnew();
    }
    if (cut_off)
        leftovers_.noteWall(reach);
    craft_.log.mark(agent::MarkKind::GoalGivenUp, leg().goal_m, craft_.senses, port);
    if (!cut_off)
        port.publish(agent::BehaviorEvent{Severity::Warning, "A goal could not be reached in time and is left out."});
    else if (survey_.cutOff_m() == 0.0 && survey_.addedLeftOut() == 0)
        port.publish(agent::BehaviorEvent{Severity::Warning,
                                          "No way leads to a goal. It is left out, like all goals to "
                                          "which no way leads."});
    craft_.startAnew();
    afterGoal(cut_off ? survey_.cutOff(craft_.settings, [&](const Vec2& at_m) { return reach.contains(at_m); })
                      : survey_.giveUp(craft_.settings, room ? LeftOut::NoWayFound : LeftOut::Late),
              port);
}

void SurveyFlight::afterGoal(SurveyEvent event, agent::CommandPort& port) {
    shiftLanes();
    if (event == SurveyEvent::AllDone) {
        if (!leftovers_.addLanes(craft_, survey_, ledger_, base_in_map_.position_m.head<2>(), port))
            return goHome(Errand::Done, "", port);
        showPlan(port);
    }
    const bool between_lanes = event == SurveyEvent::SortieDone || event == SurveyEvent::AllDone;
    if (between_lanes && survey_.goesHomeBefore(survey_.laneIndex(), craft_.battery.sinceCharge_m(), craft_.settings))
        goHome(Errand::NextSortie,
               survey_.routed() || leftovers_.begun() ? "A sortie is done; home to charge."
                                                      : "A quadrant is done; home to set the INS and to charge.",
               port);
}

void SurveyFlight::endPause(const std::string& why, agent::CommandPort& port) {
    if (!std::exchange(paused_, false))
        return;
    port.publish(agent::BehaviorEvent{Severity::Warning, "The pause ends, for " + why + "."});
}

void SurveyFlight::conclude(agent::CommandPort& port) {
    if (errand_ != Errand::Done)
        return finish(false, end_reason_, port);
    const agent::BehaviorFinished verdict = verdictOf(survey_, ledger_, craft_.settings, leftovers_.missed());
    finish(verdict.success, verdict.reason, port);
}

void SurveyFlight::order(agent::Order order, agent::CommandPort& port) {
    if (finished())
        return;
    sortie_.hold_m = craft_.senses.position2_m();
    paused_ = order == agent::Order::Pause;
    if (order != agent::Order::LandNow)
        return;
    if (phase_ == Phase::Ground && scanOver()) // Only the INS is still to be set.
        return conclude(port);
    end_reason_ = "Landed on request.";
    if (!inTheAir())
        return finish(false, end_reason_, port);
    errand_ = Errand::GivenUp;
    // A person sees whether the ground is dry.
    if (phase_ != Phase::Landing && !landNearby(-1e9, port))
        goHome(Errand::GivenUp, "No ground below has been seen to be fit for landing; the robot goes home.", port);
}

void SurveyFlight::finish(bool success, const std::string& reason, agent::CommandPort& port,
                          std::vector<std::string> sensors_missing) {
    craft_.leave(inTheAir(), port);
    phase_ = Phase::Finished;
    ending_ = agent::BehaviorFinished{success, reason, std::move(sensors_missing)};
}

} // namespace usar::airrobot
