// The time that a survey still needs, by recorded progress and by thought flights of known length.
#include <cmath>
#include <vector>

#include <QObject>
#include <QTest>

#include "robots/airrobot/flight/time_estimate.h"
#include "tests/suite/suite.h"

namespace tst_time_estimate {

using namespace usar;
using namespace usar::airrobot;

namespace {

/// When a lane was entered and finished, in seconds since the start of the mission.
struct LaneTimes {
    double from_s;
    double to_s;
};

Survey surveyOver(const Rectangle& area_in_map, const Settings& settings, const Vec2& base_m = Vec2::Zero()) {
    Pose start_in_map;
    start_in_map.position_m.head<2>() = base_m;
    const auto survey = Survey::make({"R1", start_in_map, {area_in_map.min_m, area_in_map.max_m}}, settings);
    Q_ASSERT(survey);
    return *survey;
}

/// Flies the present lane from end to end at a steady speed, with one call of `each` a second.
template <class Each>
void flyLane(Survey& survey, const LaneTimes& times, const Settings& settings, Each each) {
    const mapping::Lane lane = survey.plan().lanes[survey.laneIndex()];
    const std::size_t index = survey.laneIndex();
    survey.next(settings); // The lane is entered.
    for (double now_s = times.from_s; now_s < times.to_s; now_s += 1.0) {
        const Vec2 place_m =
            lane.start_m + (lane.end_m - lane.start_m) * ((now_s - times.from_s) / (times.to_s - times.from_s));
        survey.note(place_m);
        each(Seconds(now_s), place_m);
    }
    while (survey.laneIndex() == index)
        survey.next(settings);
}

MissionMoment onLane(Seconds now, const Vec2& place_m, double done_m) {
    return {.now = now, .stage = Stage::Lane, .position_m = place_m, .done_m = done_m, .flown_m = done_m};
}

} // namespace

class tst_TimeEstimate : public QObject {
    Q_OBJECT

    Settings settings;

    Seconds timeLeft(const TimeEstimate& estimate, const Survey& survey, const MissionState& state) const {
        return Seconds(estimate.forecast(survey, state, settings).mean);
    }

private slots:
    /// Recorded in `quick_scan.json`: the fastest and the slowest of ten seeds; then farther away, and without trees.
    void isRightWithinATenthFromATenthOn_data() {
        QTest::addColumn<Rectangle>("area");
        QTest::addColumn<Vec2>("base_m");
        QTest::addColumn<std::vector<LaneTimes>>("lanes");
        QTest::addColumn<double>("whole_s");
        const Rectangle of_quick_scan{{-30, -20}, {30, 20}};
        const Vec2 origin_m = Vec2::Zero();
        QTest::newRow("seed 2")
            << of_quick_scan << origin_m
            << std::vector<LaneTimes>{{76.4, 154.0}, {161.4, 223.4}, {230.8, 292.8}, {300.0, 363.0}, {370.4, 434.0}}
            << 478.2;
        QTest::newRow("far from the base")
            << Rectangle{{30, 30}, {80, 70}} << origin_m
            << std::vector<LaneTimes>{{76.8, 127.6}, {135.0, 186.8}, {194.2, 246.4}, {253.6, 305.6}, {313.0, 364.8}}
            << 450.8;
        QTest::newRow("volcano")
            << of_quick_scan << Vec2(185.0, -90.0)
            << std::vector<LaneTimes>{{120.6, 193.2}, {200.6, 262.4}, {269.8, 332.0}, {339.4, 401.2}, {408.6, 470.8}}
            << 641.8;
        QTest::newRow("seed 7")
            << of_quick_scan << origin_m
            << std::vector<LaneTimes>{{76.8, 153.8}, {161.2, 240.4}, {247.6, 332.6}, {339.8, 402.0}, {409.4, 482.6}}
            << 538.6;
    }
    void isRightWithinATenthFromATenthOn() {
        QFETCH(Rectangle, area);
        QFETCH(Vec2, base_m);
        QFETCH(std::vector<LaneTimes>, lanes);
        QFETCH(double, whole_s);
        Survey survey = surveyOver(area, settings, base_m);
        QCOMPARE(survey.laneCount(), lanes.size());
        TimeEstimate estimate;
        for (const LaneTimes& times : lanes) {
            flyLane(survey, times, settings, [&](Seconds now, const Vec2& place_m) {
                estimate.note(onLane(now, place_m, survey.doneLength_m()), settings);
                const double left_s = estimate.forecast(survey, {place_m, base_m, now.count()}, settings).mean;
                QVERIFY2(std::abs(now.count() + left_s - whole_s) <= 0.1 * whole_s,
                         qPrintable(QString("at %1 s: %2 s are left").arg(now.count()).arg(left_s)));
            });
        }
        QVERIFY(survey.done());
    }

    void countsAChargeAfterEachQuadrantOnlyByIns() {
        settings.quadrant_limit_m = 30.0;
        const Survey survey = surveyOver({{-30, -20}, {30, 20}}, settings);
        QCOMPARE(survey.plan().quadrants.size(), std::size_t(4));
        const double by_ins_s = TimeEstimate().whole(survey, Vec2::Zero(), 0.0, settings).time.mean;
        settings.transit_speed_m_s = 2.0; // in a hurry
        QVERIFY(by_ins_s - TimeEstimate().whole(survey, Vec2::Zero(), 0.0, settings).time.mean >
                3 * settings.recharge_time_s);
        settings.transit_speed_m_s = Settings().transit_speed_m_s;
        settings.navigate_by_truth = true;
        QVERIFY(by_ins_s - TimeEstimate().whole(survey, Vec2::Zero(), 0.0, settings).time.mean >
                3 * settings.recharge_time_s);
        settings = {};
    }

    void learnsThePaceOfTheLanes() {
        TimeEstimate estimate;
        const double first = estimate.pace(Stage::Lane).pace();
        for (int second = 0; second <= 4000; ++second)
            estimate.note(onLane(Seconds(second), Vec2::Zero(), 0.5 * second * settings.scan_speed_m_s), settings);
        const double learned = estimate.pace(Stage::Lane).pace();
        QVERIFY(first > 1.0 && learned > 1.7 && learned < 2.0);
    }

    void aWaitTeachesNothing() {
        TimeEstimate estimate;
        const double first = estimate.pace(Stage::Way).pace();
        estimate.note({.now = Seconds(0.0), .stage = Stage::Lane}, settings);
        const double way_s = 2.0 + 1.1 * 16.0 / settings.transit_speed_m_s; // As it is planned
        estimate.note({.now = Seconds(way_s / 2.0), .stage = Stage::Way, .position_m = {8.0, 0.0}}, settings);
        estimate.note({.now = Seconds(1000.0), .stage = Stage::Way, .holding = true, .position_m = {8.0, 0.0}},
                      settings);
        estimate.note({.now = Seconds(1000.0 + way_s / 2.0), .stage = Stage::Way, .position_m = {16.0, 0.0}}, settings);
        estimate.note({.now = Seconds(1001.0 + way_s / 2.0), .stage = Stage::Lane, .position_m = {16.0, 0.0}},
                      settings);
        QVERIFY(std::abs(estimate.pace(Stage::Way).pace() - first) < 1e-3);
    }

    void learnsFromEachChargeAndLanding() {
        TimeEstimate estimate;
        const double charge = estimate.pace(Stage::Charge).pace();
        const double landing = estimate.pace(Stage::Landing).pace();
        estimate.note({.now = Seconds(0.0), .stage = Stage::Landing}, settings);
        estimate.note({.now = Seconds(100.0), .stage = Stage::Landing}, settings);
        estimate.note({.now = Seconds(300.0), .stage = Stage::Charge}, settings);
        estimate.note({.now = Seconds(301.0), .stage = Stage::Way}, settings);
        QVERIFY(estimate.pace(Stage::Charge).pace() > 1.3 * charge);
        QVERIFY(estimate.pace(Stage::Landing).pace() > 1.3 * landing);
    }

    void countsTheChargesToCome() {
        const Survey survey = surveyOver({{0, 0}, {100, 100}}, settings);
        TimeEstimate estimate;
        const Seconds with_charges = timeLeft(estimate, survey, {});
        Settings enduring = settings;
        enduring.battery_range_m = 1e6;
        const Seconds without(estimate.forecast(survey, {}, enduring).mean);
        const Seconds of_charges = with_charges - without;
        QVERIFY(of_charges >= Seconds(settings.recharge_time_s)); // One at least, for 1.2 km of lanes.
        QVERIFY(of_charges < Seconds(4.0 * (settings.recharge_time_s + 200.0)));
    }

    void aLandingIsAllThatIsLeftAtTheEnd() {
        const Survey survey = surveyOver({{0, 0}, {100, 100}}, settings);
        const TimeEstimate estimate;
        MissionState state{.waiting = Seconds(7.0), .lanes_left = false};
        QCOMPARE(timeLeft(estimate, survey, state).count(), 7.0);
        state.returning = true;
        QVERIFY(timeLeft(estimate, survey, state) > Seconds(15.0));
    }

    void anEstimateRunsDownUntilTheNext() {
        const Survey survey = surveyOver({{0, 0}, {100, 100}}, settings);
        TimeEstimate estimate;
        QVERIFY(!estimate.left(Seconds(1.0)));
        estimate.update(Seconds(1.0), survey, {}, settings);
        const double first_s = estimate.left(Seconds(1.0))->mean;
        estimate.update(Seconds(1.5), survey, {.waiting = Seconds(50.0)}, settings);
        QCOMPARE(estimate.left(Seconds(1.5))->mean, first_s - 0.5);
        estimate.update(Seconds(2.5), survey, {.waiting = Seconds(50.0)}, settings);
        QCOMPARE(estimate.left(Seconds(2.5))->mean, first_s + 50.0);
    }

    void knowsWhenTheMissionTakesFarTooLong() {
        const Survey survey = surveyOver({{-30, -20}, {30, 20}}, settings, Vec2::Zero());
        TimeEstimate estimate;
        QVERIFY(!estimate.overdue());
        const double whole_s = estimate.whole(survey, Vec2::Zero(), 0.0, settings).time.mean;
        double now_s = 0.0;
        const auto fly = [&](double until_s, Stage stage, bool holding) {
            for (; now_s < until_s; now_s += 1.0) {
                estimate.note({.now = Seconds(now_s), .stage = stage, .holding = holding}, settings);
                estimate.update(Seconds(now_s), survey, {}, settings);
            }
        };
        fly(1e5, Stage::None, false); // It has not taken off.
        fly(2e5, Stage::Way, true);   // A person has told it to wait.
        fly(2e5 + 2.0 * whole_s, Stage::Way, false);
        QVERIFY(!estimate.overdue());
        fly(2e5 + 3.0 * whole_s + 1500.0, Stage::Way, false);
        QVERIFY(estimate.overdue());
    }
};

USAR_TEST(tst_TimeEstimate)

} // namespace tst_time_estimate

#include "tst_time_estimate.moc"
