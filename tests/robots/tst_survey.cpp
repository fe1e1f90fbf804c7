#include <algorithm>
#include <optional>
#include <utility>

#include <QObject>
#include <QTest>

#include "robots/airrobot/survey.h"
#include "tests/suite/suite.h"

namespace tst_survey {

using namespace usar;
using namespace usar::airrobot;

class tst_Survey : public QObject {
    Q_OBJECT

    Settings settings;

    static Survey twoLanes(int second_sortie = 0, bool routed = false) {
        mapping::CoveragePlan plan;
        plan.lanes = {{{0, 0}, {60, 0}, 0, 0}, {{60, 10}, {0, 10}, second_sortie, second_sortie}};
        plan.lane_length_m = 120.0;
        return Survey(plan, routed);
    }
    /// A tick at this place: what is flown is noted, and a goal that is reached is followed by the next one.
    std::optional<SurveyEvent> arrive(Survey& survey, const Vec2& at_m) const {
        survey.note(at_m);
        if (survey.goalReached(at_m, settings))
            return survey.next(settings);
        return std::nullopt;
    }
    /// Lanes that were added are not to be left.
    const Survey::Choice none = [](const std::vector<mapping::Lane>&) { return std::vector<mapping::Lane>(); };

    /// Flies straight from goal to goal and tells what happened.
    std::vector<SurveyEvent> flyAll(Survey& survey, Vec2 at_m) const {
        std::vector<SurveyEvent> events;
        for (int i = 0; i < 5000 && !survey.done(); ++i) {
            const Vec2 way_m = survey.aim_m(at_m, settings) - at_m;
            at_m += way_m.normalized() * std::min(0.2, way_m.norm());
            if (const auto event = arrive(survey, at_m))
                events.push_back(*event);
        }
        return events;
    }

private slots:
    void init() { settings = {}; }

    /// More lanes than are ordered by themselves.
    void inAHurryEachOfManyQuadrantsBeginsNearItsBase_data() {
        QTest::addColumn<double>("transit_m_s");
        QTest::addColumn<double>("battery_m");
        QTest::addColumn<bool>("near_base");
        QTest::newRow("flies home after each") << 2.0 << 1000.0 << true;
        QTest::newRow("in no hurry") << 1.6 << 1000.0 << false;
        QTest::newRow("flies home earlier") << 2.0 << 300.0 << false;
    }
    void inAHurryEachOfManyQuadrantsBeginsNearItsBase() {
        QFETCH(double, transit_m_s);
        QFETCH(double, battery_m);
        QFETCH(bool, near_base);
        settings.transit_speed_m_s = transit_m_s;
        settings.battery_range_m = battery_m;
        settings.lane_spacing_m = 17.0;
        settings.quadrant_limit_m = 100.0;
        const agent::Task task{"R1", Pose{}, {Vec2(-250, -250), Vec2(250, 250)}};
        const Survey survey = Survey::make(task, settings).value();
        QCOMPARE(survey.plan().quadrants.size(), std::size_t(25));
        bool near = true;
        int quadrant = -1;
        for (const mapping::Lane& lane : survey.plan().lanes) {
            const Rectangle& in = survey.plan().quadrants[static_cast<std::size_t>(lane.quadrant)];
            if (std::exchange(quadrant, lane.quadrant) != lane.quadrant && !in.contains({0, 0}))
                near = near && lane.start_m.norm() < in.center_m().norm();
        }
        QCOMPARE(near, near_base);
    }

    void aLaneIsMovedBeforeItIsEntered() {
        Survey survey = twoLanes();
        survey.shift({-1.5, 0.5});
        QCOMPARE(survey.goal_m(settings), Vec2(-1.5, 0.5));
        QVERIFY(survey.goalReached({-1.5, 0.5}, settings));
        survey.next(settings);
        survey.shift({0.0, 0.0}); // Too late: it is on the lane.
        QCOMPARE(survey.aim_m({8.5, 0.5}, settings), Vec2(8.5 + settings.lookahead_m, 0.5));
        survey.note({8.5, 0.5});
        QCOMPARE(survey.doneLength_m(), 10.0);
    }

    void fliesToTheVeryEndWhereNothingIsInTheWay() {
        Survey survey = twoLanes();
        QVERIFY(survey.goalReached({1.0, 0.0}, settings, true));
        for (const SurveyEvent event : {SurveyEvent::LaneEntered, SurveyEvent::GoalReached, SurveyEvent::GoalReached})
            QCOMPARE(survey.next(settings), event);
        QVERIFY(survey.goalReached({59.0, 0.0}, settings, true)); // The way to the next lane shows the rest.
        QCOMPARE(survey.next(settings), SurveyEvent::LaneDone);
        QVERIFY(survey.goalReached({59.0, 10.0}, settings, true));
        for (const SurveyEvent event : {SurveyEvent::LaneEntered, SurveyEvent::GoalReached, SurveyEvent::GoalReached})
            QCOMPARE(survey.next(settings), event);
        QVERIFY(!survey.goalReached({1.0, 10.0}, settings, true));
        QVERIFY(survey.goalReached({1.0, 10.0}, settings, false));
        QVERIFY(survey.goalReached({0.4, 10.0}, settings, true));
    }

    void fliesLaneAfterLane() {
        Survey survey = twoLanes();
        using enum SurveyEvent;
        QCOMPARE(flyAll(survey, {-5, -5}), (std::vector{LaneEntered, GoalReached, GoalReached, LaneDone, LaneEntered,
                                                        GoalReached, GoalReached, AllDone}));
        QCOMPARE(survey.doneLength_m(), 120.0);
        QCOMPARE(survey.goalsGivenUp(), 0);
    }

    void tellsTheEndOfASortie() {
        Survey survey = twoLanes(1);
        const auto events = flyAll(survey, {0, 0});
        QVERIFY(std::ranges::find(events, SurveyEvent::SortieDone) != events.end());
    }

    void goesHomeBetweenSorties_data() {
        QTest::addColumn<bool>("routed");
        QTest::addColumn<bool>("by_truth");
        QTest::addColumn<double>("transit_m_s");
        QTest::addColumn<double>("since_charge_m");
        QTest::addColumn<bool>("goes_home");
        QTest::newRow("planned for the battery") << true << false << 2.0 << 100.0 << true;
        QTest::newRow("planned for the battery, by ground truth") << true << true << 2.0 << 100.0 << true;
        QTest::newRow("planned for the battery, but it has just charged") << true << false << 2.0 << 50.0 << false;
        QTest::newRow("after a quadrant") << false << false << 1.6 << 100.0 << true;
        QTest::newRow("after a quadrant, by ground truth") << false << true << 1.6 << 600.0 << false;
        QTest::newRow("after a quadrant, in a hurry") << false << false << 2.0 << 100.0 << false;
        QTest::newRow("after a long quadrant, in a hurry") << false << false << 2.0 << 600.0 << true;
    }
    void goesHomeBetweenSorties() {
        QFETCH(bool, routed);
        QFETCH(bool, by_truth);
        QFETCH(double, transit_m_s);
        QFETCH(double, since_charge_m);
        QFETCH(bool, goes_home);
        settings.navigate_by_truth = by_truth;
        settings.transit_speed_m_s = transit_m_s;
        const Survey survey = twoLanes(1, routed);
        QVERIFY(!survey.goesHomeBefore(0, since_charge_m, settings));
        QCOMPARE(survey.goesHomeBefore(1, since_charge_m, settings), goes_home);
        QVERIFY(!survey.goesHomeBefore(2, since_charge_m, settings));
        QVERIFY(!twoLanes(0, routed).goesHomeBefore(1, since_charge_m, settings));
    }

    /// A lane of 60 m was broken off at 41 m, and the base is at (60, 30).
    void whatIsLeftIsPlannedAnewAfterALanding() {
        Survey survey = twoLanes(0, true);
        arrive(survey, {0, 0});
        arrive(survey, {20, 0});
        survey.note({41, 0});
        survey.interrupt();
        survey.replan({}, {60, 30}, settings, 1.0, none);
        QCOMPARE(survey.doneLength_m(), 40.0); // It resumes a meter before that place.
        QCOMPARE(survey.totalLength_m(), 120.0);
        const auto corners = survey.path_m({60, 30}, settings);
        QCOMPARE(corners.size(), std::size_t(7)); // with the base, after the first one
        QCOMPARE(corners[1], Vec2(40, 0));
        // In the order as it was, it would fly 36 m to (40, 0) and 63 m home from (0, 10).
        const std::vector<mapping::Lane> rest{{corners[3], corners[4]}, {corners[5], corners[6]}};
        QVERIFY(waysBetween_m({60, 30}, rest, {60, 30}) < 95.0);
        QCOMPARE(survey.laneIndex(), std::size_t(1));
        QVERIFY(survey.goesHomeBefore(1, 100.0, settings)); // The next sortie begins there, which it has done.
        flyAll(survey, {60, 30});
        QCOMPARE(survey.doneLength_m(), 120.0);
        QCOMPARE(survey.goalsGivenUp(), 0);
    }

    void planningAnewIsForThoseInAHurry() {
        Survey survey = twoLanes();
        const auto before = survey.path_m({60, 30}, settings);
        QVERIFY(!survey.replan({}, {60, 30}, settings, 1.0, none));
        QCOMPARE(survey.path_m({60, 30}, settings), before);
        settings.transit_speed_m_s = 2.0;
        QVERIFY(survey.replan({}, {60, 30}, settings, 1.0, none));
        QVERIFY(!survey.replan({}, {60, 30}, settings, 1.0, none)); // It is planned that way already.
        QVERIFY(survey.routed());
        QVERIFY(survey.path_m({60, 30}, settings) != before);
    }

    /// It looks for what is hidden at the end of a lane, so it must have one.
    void oneLaneStaysIfAllIsShown() {
        ScanLedger ledger({{-10, -10}, {70, 20}});
        Senses senses;
        senses.scan.emplace();
        for (double x_m = -9.75; x_m < 70.0; x_m += 0.5)
            for (double y_m = -9.75; y_m < 20.0; y_m += 0.5)
                senses.scan->hits_in_map_m.emplace_back(x_m, y_m, 0.0);
        ledger.note(senses, false, true);
        Survey survey = twoLanes(0, true);
        survey.replan(ledger, {0, 30}, settings, 1.0, none);
        QCOMPARE(survey.laneCount() - survey.laneIndex(), std::size_t(1));
        QCOMPARE(survey.doneLength_m(), 119.0);
        flyAll(survey, {0, 30});
        QCOMPARE(survey.doneLength_m(), 120.0);
    }

    /// One of two added lanes was broken off after 5 of its 20 m.
    void addedLanesAreChosenAnewAfterALanding() {
        Survey survey = twoLanes(0, true);
        flyAll(survey, {0, 0});
        survey.add({{{10, 5}, {30, 5}, 0, 0}, {{40, 5}, {40, 15}, 0, 1}});
        arrive(survey, {10, 5});
        survey.note({16, 5});
        survey.interrupt();
        std::vector<mapping::Lane> told;
        const auto choose = [&](const std::vector<mapping::Lane>& flown) {
            told = flown;
            return std::vector<mapping::Lane>{{{20, 8}, {24, 8}, 0, 0}, {{50, 8}, {50, 9}, 0, 1}};
        };
        QVERIFY(survey.replan({}, {60, 30}, settings, 1.0, choose));
        QCOMPARE(told.size(), std::size_t(1)); // and not those that were planned
        QCOMPARE(told[0].start_m, Vec2(10, 5));
        QCOMPARE(told[0].end_m, Vec2(15, 5)); // It resumes a meter before it broke off.
        QCOMPARE(survey.goal_m(settings), Vec2(20, 8));
        QVERIFY(survey.goesHomeBefore(4, 100.0, settings));
        QCOMPARE(survey.totalLength_m(), 130.0);
        QCOMPARE(survey.plannedLength_m(), 120.0);
        flyAll(survey, {60, 30});
        QCOMPARE(survey.doneLength_m(), 130.0);
    }

    void isDoneWhereNoAddedLaneIsWorthItAnyMore() {
        Survey survey = twoLanes(0, true);
        flyAll(survey, {0, 0});
        survey.add({{{10, 5}, {30, 5}, 0, 0}});
        QVERIFY(survey.replan({}, {60, 30}, settings, 1.0, none));
        QVERIFY(survey.done());
        QCOMPARE(survey.doneLength_m(), 120.0);
        QCOMPARE(survey.totalLength_m(), 120.0);
    }

    void addedLanesGoOnWithTheSorties() {
        Survey survey = twoLanes(1);
        flyAll(survey, {0, 0});
        survey.add({{{10, 5}, {14, 5}, 0, 0}, {{20, 5}, {26, 5}, 0, 1}});
        QVERIFY(!survey.goesHomeBefore(2, 100.0, settings));
        QVERIFY(survey.goesHomeBefore(3, 100.0, settings));
    }

    void aimsAheadOnTheLaneAfterADetour() {
        Survey survey = twoLanes();
        arrive(survey, {0, 0});
        const Vec2 aim_m = survey.aim_m({10, 4}, settings);
        QCOMPARE(aim_m, Vec2(10 + settings.lookahead_m, 0));
    }

    void doesNotAimBeyondTheLanesEnd() {
        Survey survey = twoLanes();
        arrive(survey, {0, 0});
        QCOMPARE(survey.aim_m({58, 0}, settings), Vec2(60, 0));
    }

    void passesAGoalInsideALaneAtADistance_data() {
        QTest::addColumn<double>("aside_m");
        QTest::addColumn<bool>("passed");
        QTest::newRow("on the lane") << 0.0 << true;
        QTest::newRow("round a tree") << 5.0 << true;
        QTest::newRow("far off") << 12.0 << false;
    }
    void passesAGoalInsideALaneAtADistance() {
        QFETCH(double, aside_m);
        QFETCH(bool, passed);
        Survey survey = twoLanes();
        arrive(survey, {0, 0});
        QCOMPARE(arrive(survey, {20, aside_m}) == SurveyEvent::GoalReached, passed);
    }

    void resumesWhereItWasInterrupted() {
        Survey survey = twoLanes();
        arrive(survey, {0, 0});
        arrive(survey, {33, 0});
        survey.interrupt();
        QVERIFY(!survey.onLane());
        QCOMPARE(survey.goal_m(settings), Vec2(32, 0)); // a metre back, so that no strip is missing
        QVERIFY(!arrive(survey, {0, 0}));
        QCOMPARE(arrive(survey, {32, 0}), std::optional(SurveyEvent::LaneEntered));
        QVERIFY(std::abs(survey.doneLength_m() - 32.0) < 1e-9);
    }

    void losesOnlyAPieceWhenItGivesUpAGoal() {
        Survey survey = twoLanes();
        arrive(survey, {0, 0});
        QCOMPARE(survey.goal_m(settings), Vec2(20, 0));
        QCOMPARE(survey.giveUp(settings, LeftOut::Late), SurveyEvent::GoalReached);
        QCOMPARE(survey.goal_m(settings), Vec2(40, 0));
        QVERIFY(survey.aim_m({5, 0}, settings).x() >= 20.0);
        QCOMPARE(survey.goalsGivenUp(), 1);
    }

    void entersALaneLaterWhenItsStartCannotBeReached() {
        Survey survey = twoLanes();
        QCOMPARE(survey.giveUp(settings, LeftOut::Late), SurveyEvent::GoalReached);
        QCOMPARE(survey.goal_m(settings), Vec2(20, 0));
        survey.giveUp(settings, LeftOut::Late);
        QCOMPARE(survey.giveUp(settings, LeftOut::Late), SurveyEvent::LaneDone); // nothing of it is left
        QCOMPARE(survey.laneIndex(), std::size_t(1));
    }

    void knowsTheShareThatItGaveUp() {
        Survey survey = twoLanes();
        survey.giveUp(settings, LeftOut::Late); // the lane's first 20 m, before it is entered
        QCOMPARE(survey.givenUp_pct(), 100.0 * 20.0 / 120.0);
        arrive(survey, {20, 0});
        arrive(survey, {32, 0});
        survey.giveUp(settings, LeftOut::Late); // 8 m of the piece are left
        QCOMPARE(survey.givenUp_pct(), 100.0 * 28.0 / 120.0);
        while (!survey.done())
            survey.giveUp(settings, LeftOut::Late);
        QCOMPARE(survey.givenUp_pct(), 90.0);
        Survey other = twoLanes();
        other.giveUp(settings, LeftOut::NoWayFound);
        QCOMPARE(other.givenUp_pct(), 0.0);
        QCOMPARE(other.cutOff_m(), 20.0);
        QCOMPARE(other.goalsGivenUp(), 0);
        QCOMPARE(twoLanes().givenUp_pct(), 0.0);
    }

    void fliesAsFarAsAWayLeads() {
        Survey survey = twoLanes();
        arrive(survey, {0, 0});
        const auto up_to_13m = [](const Vec2& at_m) { return at_m.x() < 13.5; };
        QCOMPARE(survey.cutOff(settings, up_to_13m), SurveyEvent::GoalReached);
        QVERIFY(survey.onLane());
        QCOMPARE(survey.goal_m(settings), Vec2(13, 0));
        QCOMPARE(survey.cutOff_m(), 0.0);
        arrive(survey, {13, 0});
        QCOMPARE(survey.goal_m(settings), Vec2(33, 0));
        QCOMPARE(survey.cutOff(settings, up_to_13m), SurveyEvent::LaneDone); // Nothing more of this lane
        QCOMPARE(survey.cutOff_m(), 47.0);
        QCOMPARE(survey.goal_m(settings), Vec2(60, 10));
        QCOMPARE(survey.cutOff(settings, up_to_13m), SurveyEvent::GoalReached); // It enters the next one later.
        QCOMPARE(survey.goal_m(settings), Vec2(13, 10));
        QCOMPARE(survey.cutOff_m(), 94.0);
        QCOMPARE(survey.goalsGivenUp(), 0);
        QCOMPARE(survey.givenUp_pct(), 0.0);
    }

    void leavesOutLanesToWhichNoWayLeads() {
        Survey survey = twoLanes(1);
        const auto nowhere = [](const Vec2&) { return false; };
        QCOMPARE(survey.cutOff(settings, nowhere), SurveyEvent::SortieDone);
        QCOMPARE(survey.cutOff(settings, nowhere), SurveyEvent::AllDone);
        QCOMPARE(survey.cutOff_m(), 120.0);
        QCOMPARE(survey.cutOff(settings, nowhere), SurveyEvent::AllDone);
    }

    void addedLanesCostNothingIfTheyFail() {
        Survey survey = twoLanes(1);
        flyAll(survey, {0, 0});
        survey.add({{{10, 5}, {14, 5}, 0}, {{20, 5}, {26, 5}, 0}});
        QVERIFY(!survey.done());
        QCOMPARE(survey.totalLength_m(), 130.0);
        QCOMPARE(survey.plannedLength_m(), 120.0);
        QCOMPARE(survey.doneLength_m(), 120.0);
        QCOMPARE(survey.giveUp(settings, LeftOut::Late),
                 SurveyEvent::LaneDone); // There is no flight home between them.
        QCOMPARE(survey.cutOff(settings, [](const Vec2&) { return false; }), SurveyEvent::AllDone);
        QCOMPARE(survey.addedLeftOut(), 2);
        QCOMPARE(survey.goalsGivenUp(), 0);
        QCOMPARE(survey.leftOut(), 0.0);
    }

    void triesAgainWhatWasCutOff() {
        Survey survey = twoLanes();
        arrive(survey, {0, 0});
        const auto up_to_13m = [](const Vec2& at_m) { return at_m.x() < 13.5; };
        survey.cutOff(settings, up_to_13m);
        arrive(survey, {13, 0});
        survey.cutOff(settings, up_to_13m);
        survey.giveUp(settings, LeftOut::Late); // 20 m of the second lane
        QCOMPARE(survey.cutOff_m(), 47.0);
        flyAll(survey, {40, 10});
        survey.retryCutOff();
        QCOMPARE(survey.cutOff_m(), 0.0);
        QCOMPARE(survey.goal_m(settings), Vec2(13, 0));
        QCOMPARE(survey.givenUp_pct(), 100.0 * 20.0 / 120.0);
        QCOMPARE(survey.cutOff(settings, [](const Vec2&) { return false; }), SurveyEvent::AllDone);
        QCOMPARE(survey.cutOff_m(), 47.0);
        survey.retryCutOff();
        flyAll(survey, {13, 0});
        QCOMPARE(survey.cutOff_m(), 0.0);
        QVERIFY(survey.done());
    }

    void endsWhenEverythingIsGivenUp() {
        Survey survey = twoLanes();
        int times = 0;
        while (!survey.done() && times < 100) {
            survey.giveUp(settings, LeftOut::Late);
            ++times;
        }
        QVERIFY(survey.done());
        QCOMPARE(survey.giveUp(settings, LeftOut::Late), SurveyEvent::AllDone);
        QCOMPARE(survey.next(settings), SurveyEvent::AllDone);
    }

    void hasNoShortLastPiece() {
        settings.goal_distance_m = 25.0; // 60 m: 25 and 35, not 25, 25 and 10
        Survey survey = twoLanes();
        arrive(survey, {0, 0});
        arrive(survey, {25, 0});
        QCOMPARE(survey.goal_m(settings), Vec2(60, 0));
    }

    void listsItsLanesInFlyingOrder() {
        QCOMPARE(twoLanes().path_m({5, 5}, settings), (std::vector<Vec2>{{0, 0}, {60, 0}, {60, 10}, {0, 10}}));
    }

    void itsPathLeadsHomeBetweenSorties() {
        const std::vector<Vec2> by_base{{0, 0}, {60, 0}, {5, 5}, {60, 10}, {0, 10}};
        QCOMPARE(twoLanes(1, true).path_m({5, 5}, settings), by_base);
        QCOMPARE(twoLanes(1).path_m({5, 5}, settings), by_base);
        settings.navigate_by_truth = true;
        QCOMPARE(twoLanes(1).path_m({5, 5}, settings), twoLanes().path_m({5, 5}, settings));
    }

    void isDoneBeforeItHasAPlan() {
        QVERIFY(Survey().done());
        QCOMPARE(Survey().doneLength_m(), 0.0);
    }
};

USAR_TEST(tst_Survey)

} // namespace tst_survey

#include "tst_survey.moc"
