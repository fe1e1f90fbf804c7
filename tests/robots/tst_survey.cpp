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

    static Survey twoLanes(int second_quadrant = 0) {
        mapping::CoveragePlan plan;
        plan.lanes = {{{0, 0}, {60, 0}, 0}, {{60, 10}, {0, 10}, second_quadrant}};
        plan.lane_length_m = 120.0;
        return Survey(plan);
    }
    /// A tick at this place: what is flown is noted, and a goal that is reached is followed by the next one.
    std::optional<SurveyEvent> arrive(Survey& survey, const Vec2& at_m) const {
        survey.note(at_m);
        if (survey.goalReached(at_m, settings))
            return survey.next(settings);
        return std::nullopt;
    }
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

    void inAHurryEachQuadrantBeginsNearItsBase_data() {
        QTest::addColumn<double>("transit_m_s");
        QTest::addColumn<double>("battery_m");
        QTest::addColumn<bool>("near_base");
        QTest::newRow("flies home after each") << 2.0 << 1000.0 << true;
        QTest::newRow("in no hurry") << 1.6 << 1000.0 << false;
        QTest::newRow("flies home earlier") << 2.0 << 300.0 << false;
    }
    void inAHurryEachQuadrantBeginsNearItsBase() {
        QFETCH(double, transit_m_s);
        QFETCH(double, battery_m);
        QFETCH(bool, near_base);
        settings.transit_speed_m_s = transit_m_s;
        settings.battery_range_m = battery_m;
        settings.lane_spacing_m = 17.0;
        const agent::Task task{"R1", Pose{}, {Vec2(-100, -100), Vec2(100, 100)}};
        const Survey survey = Survey::make(task, settings).value();
        QCOMPARE(survey.plan().quadrants.size(), std::size_t(4));
        double farthest_m = 0.0;
        int quadrant = -1;
        for (const mapping::Lane& lane : survey.plan().lanes)
            if (std::exchange(quadrant, lane.quadrant) != lane.quadrant)
                farthest_m = std::max(farthest_m, lane.start_m.norm());
        QCOMPARE(farthest_m < 25.0, near_base);
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

    void tellsTheEndOfAQuadrant() {
        Survey survey = twoLanes(1);
        const auto events = flyAll(survey, {0, 0});
        QVERIFY(std::ranges::find(events, SurveyEvent::QuadrantDone) != events.end());
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
        QCOMPARE(survey.cutOff(settings, nowhere), SurveyEvent::QuadrantDone);
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

    void listsItsCornersInFlyingOrder() {
        QCOMPARE(twoLanes().corners_m(), (std::vector<Vec2>{{0, 0}, {60, 0}, {60, 10}, {0, 10}}));
    }

    void isDoneBeforeItHasAPlan() {
        QVERIFY(Survey().done());
        QCOMPARE(Survey().doneLength_m(), 0.0);
    }
};

USAR_TEST(tst_Survey)

} // namespace tst_survey

#include "tst_survey.moc"
