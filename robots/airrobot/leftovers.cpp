#include "robots/airrobot/leftovers.h"

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "robots/airrobot/cross_lanes.h"
#include "robots/airrobot/lane_order.h"
#include "robots/airrobot/outlook.h"

namespace usar::airrobot {

namespace {

/// So many lanes past gaps may fail before no more are flown. All lanes that are added have at most this share of the
/// length that was planned.
constexpr int most_left_out = 3;
constexpr double most_added = 0.5;
constexpr double always_added_m = 15.0; ///< So much may be added to a survey of any length.
constexpr int most_crossings = 2;       ///< The second one sees a little of what the first one leaves.
constexpr double prior_m2 = 6000.0;     ///< The usual clutter counts as so much area that was seen.
constexpr int most_tries = 3;           ///< to get through the door
constexpr double at_place_m = 4.0;
constexpr double stub_m = 0.5;      ///< length of a lane that is only a place to go to
constexpr double beyond_m = 3.3;    ///< so far from all places that it could reach before, it is beyond the door
constexpr double room_m = 1.25;     ///< It comes up where it has so much around it,
constexpr double at_ground_m = 1.0; ///< or so near to the ground that was seen.
constexpr double before_door_m = 0.4;
constexpr double near_door_m = 4.0;
constexpr double well_within_m = 1.0; ///< of the places that it could reach before, because its pose has drifted
constexpr double never_m = 1e9;
/// A search of more would take longer than a behavior may think.
constexpr int most_judged_cells = 20000;

/// A lane that leads to a place.
mapping::Lane laneTo(const Vec2& from_m, const Vec2& to_m) {
    const Vec2 way_m = to_m - from_m;
    const Vec2 along = way_m.norm() > stub_m ? Vec2(way_m.normalized()) : Vec2(Vec2::UnitX());
    return {to_m - stub_m * along, to_m, 0};
}

GapSearch::Surroundings surroundingsOf(const Craft& craft) {
    const auto in_sight = [&craft](const Vec2& from_m, const Vec2& to_m) {
        return craft.ways.map().isInSight(from_m, to_m, craft.senses.position_m().z());
    };
    return {craft.ways.reach(craft.senses, craft.narrowest()), in_sight};
}

/// So long may all lanes be together that are added past hidden ground.
double mostAdded_m(const Survey& survey) {
    return std::max(always_added_m, most_added * survey.plannedLength_m());
}

/// Whether no other lane is between these two of a quadrant.
bool areNeighbors(const mapping::Lane& one, const mapping::Lane& other, double spacing_m) {
    constexpr double to_spare = 1.2;
    return (other.start_m - one.end_m).norm() < to_spare * spacing_m;
}

/// What scans have not hit between lanes that are done and were flown one after the other, quadrant by quadrant.
ScanLedger::Hidden hiddenBetween(std::span<const mapping::Lane> done, const ScanLedger& ledger, double spacing_m) {
    ScanLedger::Hidden sum;
    for (std::size_t i = 1; i < done.size(); ++i) {
        if (done[i].quadrant != done[i - 1].quadrant || !areNeighbors(done[i - 1], done[i], spacing_m))
            continue;
        const auto between = ledger.hiddenIn({done[i - 1].start_m.cwiseMin(done[i].start_m).cwiseMin(done[i].end_m),
                                              done[i - 1].start_m.cwiseMax(done[i].start_m).cwiseMax(done[i].end_m)});
        sum.area_m2 += between.area_m2;
        sum.hidden_m2 += between.hidden_m2;
    }
    return sum;
}

double expectedLanes_m(const mapping::CoveragePlan& plan, std::size_t done, const ScanLedger& ledger,
                       const Settings& settings) {
    const auto seen =
        hiddenBetween(std::span(plan.lanes).first(std::min(done, plan.lanes.size())), ledger, settings.lane_spacing_m);
    const double before = ledger_share * hiddenShare(plan, settings, clutter::usual);
    const double share = (before * prior_m2 + seen.hidden_m2) / (prior_m2 + seen.area_m2);
    return std::min(most_added * plan.lane_length_m, addedLanes(share, areaOf_m2(plan), settings).length_m);
}

void note(agent::CommandPort& port, const std::string& words) {
    port.publish(agent::BehaviorEvent{Severity::Note, words});
}

} // namespace

void Leftovers::startAnew() {
    state_ = Door::Unknown;
    door_m_.reset();
    tries_ = 0;
    walled_ = false;
}

void Leftovers::noteWall(const ReachablePlaces& reach) {
    if (state_ != Door::Unknown)
        return;
    reach_ = reach;
    walled_ = true;
}

bool Leftovers::addLanes(Craft& craft, Survey& survey, const ScanLedger& ledger, const Vec2& base_m,
                         agent::CommandPort& port) {
    begun_ = true;
    const bool open = crosses(craft, survey);
    if (open ? crossOnce(craft, survey, ledger, base_m, port)
             : (state_ == Door::ToDoor && tryDoor(craft, survey, base_m, port)) ||
                   closeGaps(craft, survey, ledger, port) || tryDoor(craft, survey, base_m, port))
        return true;
    if (knowsWays(craft, ledger))
        missed_ = GapSearch::missed(ledger, surroundingsOf(craft));
    if (open) // Walls divide cells, too, but nothing behind them is missed.
        missed_ += (1.0 - missed_) * ledger.hiddenInSeen();
    return false;
}

double Leftovers::expected_m(const Craft& craft, const Survey& survey, const ScanLedger& ledger) {
    if (begun_ || !crosses(craft, survey))
        return 0.0;
    if (foretold_at_ != survey.laneIndex()) {
        foretold_at_ = survey.laneIndex();
        expected_m_ = expectedLanes_m(survey.plan(), survey.laneIndex(), ledger, craft.settings);
    }
    return expected_m_;
}

bool Leftovers::crosses(const Craft& craft, const Survey& survey) {
    return !craft.overhead.hasCeiling() && craft.mayClimb() && survey.cutOff_m() == 0.0;
}

bool Leftovers::knowsWays(const Craft& craft, const ScanLedger& ledger) {
    return craft.battery.charges() == 0 && ledger.columns() * ledger.rows() <= most_judged_cells;
}

bool Leftovers::crossOnce(const Craft& craft, Survey& survey, const ScanLedger& ledger, const Vec2& base_m,
                          agent::CommandPort& port) {
    if (crossings_ >= most_crossings)
        return false;
    ++crossings_;
    gaps_left_out_ = survey.addedLeftOut(); // Only lanes past gaps count for those.
    const Settings& settings = craft.settings;
    const LaneTerms terms{settings.least_gain_m, mostAdded_m(survey) - added_m_, settings.ground_resolution_m,
                          enduranceOf(settings, craft.battery.sinceCharge_m())};
    return fly(crossLanes(ledger, terms, craft.senses.position2_m(), base_m), survey,
               "More lanes show ground that was hidden: ", port);
}

std::vector<mapping::Lane> Leftovers::chosenAnew(const Craft& craft, const Survey& survey, const ScanLedger& ledger,
                                                 const Vec2& base_m, const std::vector<mapping::Lane>& flown,
                                                 double detour) {
    const double flown_m = lengthOf_m(flown);
    const Settings& settings = craft.settings;
    const LaneTerms terms{settings.least_gain_m, mostAdded_m(survey) - flown_m, settings.ground_resolution_m,
                          enduranceOf(settings, 0.0, detour), flown};
    std::vector<mapping::Lane> lanes = crossLanes(ledger, terms, base_m, base_m);
    added_m_ = flown_m + lengthOf_m(lanes);
    if (lanes.empty())
        crossings_ = most_crossings;
    return lanes;
}

bool Leftovers::fly(const std::vector<mapping::Lane>& lanes, Survey& survey, const std::string& why,
                    agent::CommandPort& port) {
    if (lanes.empty())
        return false;
    added_m_ += lengthOf_m(lanes);
    survey.add(lanes);
    note(port, why + std::to_string(lanes.size()) + ".");
    return true;
}

bool Leftovers::closeGaps(Craft& craft, Survey& survey, const ScanLedger& ledger, agent::CommandPort& port) {
    // After a charge, the robot does not know any more where the walls are.
    if (craft.battery.charges() > 0 || GapSearch::isNeedless(ledger) ||
        survey.addedLeftOut() - gaps_left_out_ > most_left_out || added_m_ > most_added * survey.plannedLength_m())
        return false;
    const auto lanes = gaps_.lanes(ledger, surroundingsOf(craft), craft.senses.position2_m());
    return fly(lanes, survey, "The map has gaps that can be reached; lanes past them: ", port);
}

bool Leftovers::tryDoor(Craft& craft, Survey& survey, const Vec2& base_m, agent::CommandPort& port) {
    const Vec2 here_m = craft.senses.position2_m();
    const bool under = state_ == Door::Outward && craft.ways.isUnder();
    if (!walled_ || !craft.overhead.hasCeiling() || survey.cutOff_m() == 0.0 || (state_ >= Door::Outward && !under) ||
        (state_ == Door::ToDoor && (here_m - sink_at_m_).norm() > at_place_m) || tries_ >= most_tries)
        return false;
    if (under) { // Its estimate of the pose has drifted, so its map may show the door where it is not.
        craft.ways.clear();
        ++tries_;
        survey.add({laneTo(here_m, ground_m_)});
        return true;
    }
    if (state_ == Door::Unknown) {
        const auto ground_m = craft.ways.groundBehindDoor_m(base_m, reach_);
        if (!ground_m)
            return false;
        ground_m_ = *ground_m;
        // At its base it may sink in any case: it has stood there.
        sink_at_m_ = craft.ways.placeToSink_m(base_m, ground_m_, reach_, craft.memory).value_or(base_m);
    }
    if ((here_m - sink_at_m_).norm() > at_place_m) {
        state_ = Door::ToDoor;
        survey.add({laneTo(here_m, sink_at_m_)});
        return true;
    }
    state_ = Door::Outward;
    ++tries_;
    craft.goUnder(sink_at_m_);
    survey.add({laneTo(here_m, ground_m_)});
    note(port, "Ground was seen behind a wall; the robot looks for a door to it near the ground.");
    return true;
}

bool Leftovers::comeBack(Craft& craft) {
    const Vec2 here_m = craft.senses.position2_m();
    const auto isWithin = [&](const Vec2& aside_m) { return reach_.contains(here_m + well_within_m * aside_m); };
    const std::array around{Vec2(0, 0), Vec2(1, 0), Vec2(-1, 0), Vec2(0, 1), Vec2(0, -1)};
    if (!craft.ways.isUnder() || !std::ranges::all_of(around, isWithin) ||
        !craft.ways.map().hasRoom(here_m, craft.senses.position_m().z(), room_m))
        return false;
    state_ = Door::Back;
    craft.comeUp();
    return true;
}

bool Leftovers::passDoor(Craft& craft, Survey& survey, bool returning, agent::CommandPort& port) {
    const Vec2 here_m = craft.senses.position2_m();
    const double to_door_m = returning && door_m_ ? (here_m - *door_m_).norm() : never_m;
    craft.ways.comeNear(to_door_m < near_door_m); // Higher up, there is a wall beside it.
    if (to_door_m < before_door_m) {
        state_ = Door::Homeward;
        craft.goUnder(*door_m_);
        door_m_.reset();
    }
    if (state_ == Door::Homeward)
        return returning && comeBack(craft);
    if (state_ != Door::Outward || reach_.leadsNear(here_m, beyond_m))
        return false;
    if ((here_m - ground_m_).norm() > at_ground_m &&
        !craft.ways.map().hasRoom(here_m, craft.senses.position_m().z(), room_m))
        return false;
    state_ = Door::Through;
    door_m_ = here_m;
    gaps_left_out_ = survey.addedLeftOut();
    craft.comeUp();
    survey.interrupt();
    survey.retryCutOff();
    note(port, "The robot is through the door and flies the lanes that were cut off.");
    return true;
}

} // namespace usar::airrobot
