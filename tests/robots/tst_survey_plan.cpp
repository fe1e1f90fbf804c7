#include <algorithm>
#include <cmath>

#include <QTest>

#include "robots/airrobot/survey_plan.h"
#include "tests/suite/suite.h"

namespace tst_survey_plan {

using namespace usar;
using namespace usar::airrobot;

namespace {

/// The preset *balanced*.
Settings balanced() {
    Settings settings;
    settings.scan_altitude_m = 8.0;
    settings.lane_spacing_m = settings.scan_speed_m_s = Settings::by_resolution;
    settings.transit_speed_m_s = 2.0;
    settings.least_gain_m = 0.72;
    return settings.asAsked();
}

Rectangle areaOf(double x_m, double y_m, double width_m, double height_m) {
    return {{x_m, y_m}, {x_m + width_m, y_m + height_m}};
}

/// The flight with this plan, with a full battery.
double flown_m(const mapping::CoveragePlan& plan, const Settings& settings) {
    return flight_m({0, 0}, plan.lanes, {0, 0}, enduranceOf(settings));
}

ScanLedger shownUpTo(double x_m, const Rectangle& area, const std::vector<Vec2>& holes_m = {}) {
    ScanLedger ledger(area);
    Senses senses;
    senses.scan.emplace();
    for (double at_x_m = area.min_m.x() + 0.25; at_x_m < x_m; at_x_m += 0.5)
        for (double at_y_m = area.min_m.y() + 0.25; at_y_m < area.max_m.y(); at_y_m += 0.5)
            if (std::ranges::none_of(holes_m,
                                     [&](const Vec2& at_m) { return (at_m - Vec2(at_x_m, at_y_m)).norm() < 3.0; }))
                senses.scan->hits_in_map_m.emplace_back(at_x_m, at_y_m, 0.0);
    ledger.note(senses, false, true);
    return ledger;
}

} // namespace

class tst_SurveyPlan : public QObject {
    Q_OBJECT
private slots:
    /// Every point of the area is within half a spacing of a lane, and the lanes are no longer than that takes.
    void eachPlanCoversItsArea_data() {
        QTest::addColumn<double>("x_m");
        QTest::addColumn<double>("y_m");
        QTest::addColumn<double>("width_m");
        QTest::addColumn<double>("height_m");
        QTest::newRow("a square around the base") << -100.0 << -100.0 << 200.0 << 200.0;
        QTest::newRow("a little more than a quadrant") << -80.0 << -70.0 << 160.0 << 140.0;
        QTest::newRow("a band far from the base") << 60.0 << -120.0 << 40.0 << 290.0;
        QTest::newRow("a long piece") << -140.0 << 10.0 << 280.0 << 76.0;
        QTest::newRow("a room") << -8.0 << -6.0 << 16.0 << 12.0;
    }
    void eachPlanCoversItsArea() {
        QFETCH(double, x_m);
        QFETCH(double, y_m);
        QFETCH(double, width_m);
        QFETCH(double, height_m);
        const Settings settings = balanced();
        const Rectangle area = areaOf(x_m, y_m, width_m, height_m);
        const SurveyPlan plan = planSurvey(area, {0, 0}, settings).value();
        QVERIFY(plan.routed);
        double lanes_m = 0.0;
        int sortie = plan.coverage.lanes.front().sortie;
        for (const mapping::Lane& lane : plan.coverage.lanes) {
            lanes_m += (lane.end_m - lane.start_m).norm();
            QVERIFY(lane.sortie == sortie || lane.sortie == sortie + 1);
            sortie = lane.sortie;
        }
        QVERIFY(std::abs(lanes_m - plan.coverage.lane_length_m) < 1e-6);
        const double least_m = width_m * height_m / settings.lane_spacing_m;
        QVERIFY(lanes_m < least_m + 4.0 * std::max(width_m, height_m));
        QVERIFY(plan.coverage.transit_length_m >= waysBetween_m({0, 0}, plan.coverage.lanes, {0, 0}) - 1e-6);
        for (double at_x_m = x_m + 0.5; at_x_m < x_m + width_m; at_x_m += 3.0)
            for (double at_y_m = y_m + 0.5; at_y_m < y_m + height_m; at_y_m += 3.0)
                QVERIFY(std::ranges::any_of(plan.coverage.lanes, [&](const mapping::Lane& lane) {
                    const Vec2 least_m = lane.start_m.cwiseMin(lane.end_m), most_m = lane.start_m.cwiseMax(lane.end_m);
                    const Vec2 at_m(at_x_m, at_y_m);
                    return (at_m - at_m.cwiseMax(least_m).cwiseMin(most_m)).norm() <=
                           0.5 * settings.lane_spacing_m + 1e-6;
                }));
    }

    /// What the plan saves against quadrants, each begun near the base, where these do not fit the battery.
    void shortensTheFlight_data() {
        QTest::addColumn<double>("width_m");
        QTest::addColumn<double>("height_m");
        QTest::addColumn<double>("at_most"); // times the way by quadrants
        QTest::newRow("tall_test: quadrants fit the battery") << 200.0 << 200.0 << 0.97;
        QTest::newRow("quick_scan: one battery lasts for all") << 60.0 << 40.0 << 1.0;
        QTest::newRow("just above a quadrant") << 160.0 << 160.0 << 0.9;
        QTest::newRow("long") << 280.0 << 80.0 << 0.9;
        QTest::newRow("wide lanes") << 230.0 << 160.0 << 0.9;
    }
    void shortensTheFlight() {
        QFETCH(double, width_m);
        QFETCH(double, height_m);
        QFETCH(double, at_most);
        const Settings settings = balanced();
        const Rectangle area = areaOf(-width_m / 2.0, -height_m / 2.0, width_m, height_m);
        mapping::CoveragePlan quadrants =
            mapping::planCoverage(area, {0, 0}, {settings.lane_spacing_m, 150.0, true}).value();
        double by_quadrants_m = 0.0;
        for (std::size_t i = 0; i < quadrants.quadrants.size(); ++i) {
            std::vector<mapping::Lane> lanes;
            std::ranges::copy_if(quadrants.lanes, std::back_inserter(lanes),
                                 [i](const mapping::Lane& lane) { return lane.quadrant == static_cast<int>(i); });
            const Endurance endurance = enduranceOf(settings);
            by_quadrants_m += flight_m({0, 0}, lanes, {0, 0}, endurance) + (i > 0 ? endurance.charge_m : 0.0);
        }
        const SurveyPlan plan = planSurvey(area, {0, 0}, settings).value();
        const double share = flown_m(plan.coverage, settings) / by_quadrants_m;
        QVERIFY2(share < at_most + 1e-9, qPrintable(QString::number(share)));
        if (at_most == 1.0) // The order in which neighbors follow each other is kept.
            for (std::size_t i = 0; i < quadrants.lanes.size(); ++i)
                QCOMPARE(plan.coverage.lanes[i].start_m, quadrants.lanes[i].start_m);
    }

    void fliesByQuadrants_data() {
        QTest::addColumn<double>("transit_m_s");
        QTest::addColumn<double>("width_m");
        QTest::addColumn<bool>("routed");
        QTest::newRow("in a hurry") << 2.0 << 200.0 << true;
        QTest::newRow("in no hurry") << 1.6 << 200.0 << false;
        QTest::newRow("in a hurry, but over many lanes") << 2.0 << 1200.0 << false;
    }
    void fliesByQuadrants() {
        QFETCH(double, transit_m_s);
        QFETCH(double, width_m);
        QFETCH(bool, routed);
        Settings settings = balanced();
        settings.transit_speed_m_s = transit_m_s;
        settings.scan_speed_m_s = 1.0;
        const SurveyPlan plan = planSurvey(areaOf(-100, -100, width_m, 200), {0, 0}, settings).value();
        QCOMPARE(plan.routed, routed);
        for (const mapping::Lane& lane : plan.coverage.lanes)
            QVERIFY(routed || lane.sortie == lane.quadrant);
    }

    /// A battery that lasts for everything does not keep the INS from drifting.
    void theInsEndsASortieEarlierThanTheBattery_data() {
        QTest::addColumn<bool>("by_truth");
        QTest::newRow("by INS") << false;
        QTest::newRow("by ground truth") << true;
    }
    void theInsEndsASortieEarlierThanTheBattery() {
        QFETCH(bool, by_truth);
        Settings settings = balanced();
        settings.battery_range_m = 20000.0;
        settings.navigate_by_truth = by_truth;
        const SurveyPlan plan = planSurvey(areaOf(-100, -100, 200, 200), {0, 0}, settings).value();
        double longest_m = 0.0;
        for (auto first = plan.coverage.lanes.begin(); first != plan.coverage.lanes.end();) {
            const auto last = std::find_if(first, plan.coverage.lanes.end(),
                                           [&](const mapping::Lane& lane) { return lane.sortie != first->sortie; });
            longest_m = std::max(longest_m, flight_m({0, 0}, {first, last}, {0, 0}, {}));
            first = last;
        }
        const double most_m = 1000.0 + 2.0 * std::hypot(100.0, 100.0) + 24.0 * turns_m;
        QVERIFY2(by_truth ? longest_m > 2000.0 : longest_m < most_m, qPrintable(QString::number(longest_m)));
    }

    /// The survey ends with the first lane that it cannot reach, so those that it can are flown before.
    void whatIsOutOfReachComesLast() {
        const SurveyPlan plan = planSurvey(areaOf(0, -50, 900, 100), {0, 0}, balanced()).value();
        bool far = false;
        for (const mapping::Lane& lane : plan.coverage.lanes) {
            const bool out_of_reach = std::max(lane.start_m.norm(), lane.end_m.norm()) > 410.0;
            QVERIFY(out_of_reach || !far);
            far = far || out_of_reach;
        }
        QVERIFY(far);
        QVERIFY(std::min(plan.coverage.lanes[0].start_m.norm(), plan.coverage.lanes[0].end_m.norm()) < 410.0);
    }

    void leavesOutWhatIsShown_data() {
        QTest::addColumn<double>("shown_to_m");
        QTest::addColumn<QList<QPointF>>("holes_m");
        QTest::addColumn<double>("from_m"); // of a lane from 0 m to 60 m
        QTest::newRow("nothing") << 0.0 << QList<QPointF>{} << 0.0;
        QTest::newRow("a third") << 20.0 << QList<QPointF>{} << 20.0;
        QTest::newRow("up to something hidden") << 40.0 << QList<QPointF>{{23.0, 4.0}} << 20.0;
        QTest::newRow("what is hidden beside the strip does not count") << 40.0 << QList<QPointF>{{23.0, 14.0}} << 40.0;
        QTest::newRow("all") << 60.0 << QList<QPointF>{} << 60.0;
    }
    void leavesOutWhatIsShown() {
        QFETCH(double, shown_to_m);
        QFETCH(QList<QPointF>, holes_m);
        QFETCH(double, from_m);
        std::vector<Vec2> holes;
        for (const QPointF& at_m : holes_m)
            holes.emplace_back(at_m.x(), at_m.y());
        const ScanLedger ledger = shownUpTo(shown_to_m, areaOf(0, -20, 60, 40), holes);
        const mapping::Lane lane{{0, 0}, {60, 0}, 3};
        const mapping::Lane rest = withoutShownEnds(lane, ledger, balanced());
        QCOMPARE(rest.start_m, Vec2(from_m, 0.0));
        QCOMPARE(rest.end_m, Vec2(60.0, 0.0));
        QCOMPARE(rest.quadrant, 3);
        const mapping::Lane back = withoutShownEnds(turned(lane), ledger, balanced());
        QCOMPARE(back.start_m, from_m < 60.0 ? Vec2(60.0, 0.0) : Vec2(0.0, 0.0));
        QCOMPARE(back.end_m, from_m < 60.0 ? Vec2(from_m, 0.0) : Vec2(0.0, 0.0));
        const auto left = replanned({lane}, ledger, {30, 30}, balanced(), 1.0);
        QCOMPARE(left.size(), std::size_t(from_m < 60.0 ? 1 : 0));
    }

    void whatIsTooLargeToBeWatchedIsNotLeftOut() {
        QCOMPARE(replanned({{{0, 0}, {60, 0}}}, ScanLedger(), {0, 0}, balanced(), 1.0).size(), std::size_t(1));
    }

    /// A plan for the detours that are flown is better for those than one for straight ways.
    void learnsFromTheDetours() {
        const SurveyPlan plan = planSurvey(areaOf(-100, -100, 200, 200), {0, 0}, balanced()).value();
        const auto flown_with_detours_m = [&](double planned_for) {
            const auto lanes = replanned(plan.coverage.lanes, ScanLedger(), {0, 0}, balanced(), planned_for);
            return flight_m({0, 0}, lanes, {0, 0}, enduranceOf(balanced(), 0.0, 1.4));
        };
        const double knowing_m = flown_with_detours_m(1.4), not_knowing_m = flown_with_detours_m(1.0);
        QVERIFY2(knowing_m < 0.99 * not_knowing_m, qPrintable(QString("%1, %2").arg(knowing_m).arg(not_knowing_m)));
    }
};

USAR_TEST(tst_SurveyPlan)

} // namespace tst_survey_plan

#include "tst_survey_plan.moc"
