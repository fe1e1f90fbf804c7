#include <QTest>

#include <algorithm>
#include <cmath>

#include "core/base/random.h"
#include "core/mapping/coverage_path.h"
#include "tests/suite/suite.h"

namespace tst_coverage_path {

using namespace usar;
using namespace usar::mapping;

namespace {

double distanceToLane(const Lane& lane, const Vec2& point_m) {
    const Vec2 along_m = lane.end_m - lane.start_m;
    const double part = std::clamp((point_m - lane.start_m).dot(along_m) / along_m.squaredNorm(), 0.0, 1.0);
    return (lane.start_m + part * along_m - point_m).norm();
}

double distanceToPlan(const CoveragePlan& plan, const Vec2& point_m) {
    double nearest_m = qInf();
    for (const Lane& lane : plan.lanes)
        nearest_m = std::min(nearest_m, distanceToLane(lane, point_m));
    return nearest_m;
}

double transit(const CoveragePlan& plan, const Vec2& base_m) {
    double length_m = 0.0;
    Vec2 position_m = base_m;
    for (const Lane& lane : plan.lanes) {
        length_m += (lane.start_m - position_m).norm();
        position_m = lane.end_m;
    }
    return length_m + (base_m - position_m).norm();
}

} // namespace

class tst_CoveragePath : public QObject {
    Q_OBJECT
private slots:
    void beginsAtTheCornerNearestToTheBase_data();
    void beginsAtTheCornerNearestToTheBase();
    void needsTheFewestLanes_data();
    void needsTheFewestLanes();
    void cutsLargeAreasIntoEqualQuadrants_data();
    void cutsLargeAreasIntoEqualQuadrants();
    void coversEveryPointOfRandomAreas();
    void eachQuadrantBeginsAtTheCornerNearestToTheRobot();
    void eachQuadrantBeginsNearABaseToWhichTheRobotReturns();
    void transitBetweenQuadrantsStaysShort();
    void refusesTheRestAndSaysWhy_data();
    void refusesTheRestAndSaysWhy();
};

void tst_CoveragePath::beginsAtTheCornerNearestToTheBase_data() {
    QTest::addColumn<Rectangle>("area");
    QTest::addColumn<Vec2>("base_m");
    QTest::addColumn<Vec2>("start_m");
    QTest::addColumn<Vec2>("end_m");
    const Rectangle wide{{0, 0}, {60, 40}};
    QTest::newRow("low left") << wide << Vec2(-5, -5) << Vec2(0, 5) << Vec2(60, 5);
    QTest::newRow("low right") << wide << Vec2(70, 1) << Vec2(60, 5) << Vec2(0, 5);
    QTest::newRow("top left") << wide << Vec2(1, 39) << Vec2(0, 35) << Vec2(60, 35);
    QTest::newRow("top right, from inside") << wide << Vec2(31, 21) << Vec2(60, 35) << Vec2(0, 35);
    const Rectangle tall{{-20, -30}, {20, 30}};
    QTest::newRow("the longer side is y") << tall << Vec2(100, 100) << Vec2(15, 30) << Vec2(15, -30);
}

void tst_CoveragePath::beginsAtTheCornerNearestToTheBase() {
    QFETCH(Rectangle, area);
    QFETCH(Vec2, base_m);
    QFETCH(Vec2, start_m);
    QFETCH(Vec2, end_m);
    const CoveragePlan plan = planCoverage(area, base_m, {10.0}).value();
    QCOMPARE(plan.lanes.size(), std::size_t(4));
    QVERIFY((plan.lanes[0].start_m - start_m).norm() < 1e-9);
    QVERIFY((plan.lanes[0].end_m - end_m).norm() < 1e-9);
    QCOMPARE(plan.lane_length_m, 240.0);
}

void tst_CoveragePath::needsTheFewestLanes_data() {
    QTest::addColumn<double>("shorter_side_m");
    QTest::addColumn<int>("lanes");
    QTest::newRow("a strip thinner than a lane") << 3.0 << 1;
    QTest::newRow("exactly one") << 10.0 << 1;
    QTest::newRow("a little more than one") << 10.1 << 2;
    QTest::newRow("rounding does not add a lane") << 0.1 * 300 + 1e-9 << 3;
    QTest::newRow("ten") << 100.0 << 10;
}

void tst_CoveragePath::needsTheFewestLanes() {
    QFETCH(double, shorter_side_m);
    QFETCH(int, lanes);
    const CoveragePlan plan = planCoverage({{0, 0}, {120, shorter_side_m}}, {0, 0}, {10.0}).value();
    QCOMPARE(static_cast<int>(plan.lanes.size()), lanes);
}

void tst_CoveragePath::cutsLargeAreasIntoEqualQuadrants_data() {
    QTest::addColumn<double>("width_m");
    QTest::addColumn<double>("height_m");
    QTest::addColumn<int>("quadrants");
    QTest::newRow("small") << 60.0 << 40.0 << 1;
    QTest::newRow("at the limit") << 150.0 << 150.0 << 1;
    QTest::newRow("one side over the limit") << 200.0 << 100.0 << 2;
    QTest::newRow("the thesis's world") << 200.0 << 200.0 << 4;
    QTest::newRow("a square kilometre") << 1000.0 << 1000.0 << 49;
}

void tst_CoveragePath::cutsLargeAreasIntoEqualQuadrants() {
    QFETCH(double, width_m);
    QFETCH(double, height_m);
    QFETCH(int, quadrants);
    const Rectangle area{{-width_m / 2, -height_m / 2}, {width_m / 2, height_m / 2}};
    const CoveragePlan plan = planCoverage(area, {0, 0}, {10.0}).value();
    QCOMPARE(static_cast<int>(plan.quadrants.size()), quadrants);
    double area_m2 = 0.0;
    for (const Rectangle& quadrant : plan.quadrants) {
        QVERIFY(std::abs(quadrant.area_m2() - plan.quadrants[0].area_m2()) < 1e-6);
        QVERIFY(std::max(quadrant.width_m(), quadrant.height_m()) <= 150.0 + 1e-6);
        area_m2 += quadrant.area_m2();
    }
    QVERIFY(std::abs(area_m2 - area.area_m2()) < 1e-3);
    int quadrant = 0;
    for (const Lane& lane : plan.lanes) { // one by one: no lane returns to a quadrant that was left
        QVERIFY(lane.quadrant == quadrant || lane.quadrant == quadrant + 1);
        quadrant = lane.quadrant;
    }
    QCOMPARE(quadrant, quadrants - 1);
}

void tst_CoveragePath::coversEveryPointOfRandomAreas() {
    Random random = seeded(11, 4);
    for (int run = 0; run < 60; ++run) {
        const Vec2 low_m(uniform(random, -300, 300), uniform(random, -300, 300));
        const Rectangle area{low_m, low_m + Vec2(uniform(random, 1, 400), uniform(random, 1, 400))};
        const Vec2 base_m(uniform(random, -300, 300), uniform(random, -300, 300));
        const CoverageOptions options{uniform(random, 2, 25), uniform(random, 60, 200)};
        const CoveragePlan plan = planCoverage(area, base_m, options).value();
        for (const Lane& lane : plan.lanes) {
            const Rectangle& quadrant = plan.quadrants[std::size_t(lane.quadrant)];
            QVERIFY(quadrant.contains(lane.start_m) && quadrant.contains(lane.end_m));
            const Vec2 along_m = (lane.end_m - lane.start_m).cwiseAbs();
            QVERIFY(along_m.minCoeff() < 1e-9); // parallel to the longer side
            QCOMPARE(along_m.maxCoeff(), std::max(quadrant.width_m(), quadrant.height_m()));
        }
        const double shorter_m = std::min(plan.quadrants[0].width_m(), plan.quadrants[0].height_m());
        const double lanes_each = double(plan.lanes.size()) / double(plan.quadrants.size());
        QVERIFY((lanes_each - 1) * options.lane_spacing_m < shorter_m + 1e-3);
        for (int i = 0; i < 200; ++i) {
            const Vec2 point_m(uniform(random, area.min_m.x(), area.max_m.x()),
                               uniform(random, area.min_m.y(), area.max_m.y()));
            QVERIFY(distanceToPlan(plan, point_m) <= options.lane_spacing_m / 2 + 1e-3);
        }
        QVERIFY(std::abs(plan.transit_length_m - transit(plan, base_m)) < 1e-6);
    }
}

void tst_CoveragePath::eachQuadrantBeginsAtTheCornerNearestToTheRobot() {
    const Vec2 base_m(3, -7);
    const CoveragePlan plan = planCoverage({{-170, -120}, {150, 140}}, base_m, {10.0}).value();
    Vec2 position_m = base_m;
    int quadrant = -1;
    for (const Lane& lane : plan.lanes) {
        if (lane.quadrant != quadrant) {
            const Rectangle& area = plan.quadrants[std::size_t(lane.quadrant)];
            const Vec2 from_center_m = position_m - area.center_m();
            const Vec2 start_m = lane.start_m - area.center_m();
            QVERIFY(from_center_m.x() * start_m.x() >= 0.0 && from_center_m.y() * start_m.y() >= 0.0);
        }
        quadrant = lane.quadrant;
        position_m = lane.end_m;
    }
}

void tst_CoveragePath::eachQuadrantBeginsNearABaseToWhichTheRobotReturns() {
    const Vec2 base_m(3, -7);
    CoverageOptions options{10.0};
    options.returns = true;
    const CoveragePlan plan = planCoverage({{-170, -120}, {150, 140}}, base_m, options).value();
    QCOMPARE(plan.quadrants.size(), std::size_t(6));
    double transit_m = 0.0;
    for (std::size_t i = 0; i < plan.lanes.size(); ++i) {
        const bool first = i == 0 || plan.lanes[i].quadrant != plan.lanes[i - 1].quadrant;
        const bool last = i + 1 == plan.lanes.size() || plan.lanes[i].quadrant != plan.lanes[i + 1].quadrant;
        transit_m += (plan.lanes[i].start_m - (first ? base_m : plan.lanes[i - 1].end_m)).norm();
        transit_m += last ? (base_m - plan.lanes[i].end_m).norm() : 0.0;
        const Vec2 center_m = plan.quadrants[std::size_t(plan.lanes[i].quadrant)].center_m();
        const Vec2 from_center_m = base_m - center_m;
        const Vec2 start_m = plan.lanes[i].start_m - center_m;
        QVERIFY(!first || (from_center_m.x() * start_m.x() >= 0.0 && from_center_m.y() * start_m.y() >= 0.0));
    }
    QVERIFY(std::abs(plan.transit_length_m - transit_m) < 1e-6);
}

void tst_CoveragePath::transitBetweenQuadrantsStaysShort() {
    // 7 x 7 quadrants of 143 m: the lanes' own side steps are 14 x 9.5 m each; to the next quadrant it is about a side.
    const CoveragePlan plan = planCoverage({{0, 0}, {1000, 1000}}, {0, 0}, {10.0}).value();
    const double side_m = 1000.0 / 7;
    const double side_steps_m = 49 * 14 * (side_m / 15);
    QVERIFY2(plan.transit_length_m < side_steps_m + 48 * side_m + 1000 * std::sqrt(2.0),
             qPrintable(QString::number(plan.transit_length_m)));
}

void tst_CoveragePath::refusesTheRestAndSaysWhy_data() {
    QTest::addColumn<Rectangle>("area");
    QTest::addColumn<double>("spacing_m");
    QTest::addColumn<double>("limit_m");
    QTest::addColumn<QString>("what");
    const Rectangle good{{0, 0}, {60, 40}};
    QTest::newRow("no width") << Rectangle{{5, 0}, {5, 40}} << 10.0 << 150.0 << "no size";
    QTest::newRow("upside down") << Rectangle{{0, 40}, {60, 0}} << 10.0 << 150.0 << "no size";
    QTest::newRow("not a number") << Rectangle{{0, 0}, {qQNaN(), 40}} << 10.0 << 150.0 << "no size";
    QTest::newRow("infinite") << Rectangle{{0, 0}, {qInf(), 40}} << 10.0 << 150.0 << "no size";
    QTest::newRow("spacing zero") << good << 0.0 << 150.0 << "lane spacing";
    QTest::newRow("spacing not a number") << good << qQNaN() << 150.0 << "lane spacing";
    QTest::newRow("limit negative") << good << 10.0 << -1.0 << "quadrant limit";
    QTest::newRow("a million lanes") << Rectangle{{0, 0}, {1e7, 1e7}} << 10.0 << 150.0 << "100000 lanes";
    QTest::newRow("lanes like hairs") << good << 1e-9 << 150.0 << "100000 lanes";
}

void tst_CoveragePath::refusesTheRestAndSaysWhy() {
    QFETCH(Rectangle, area);
    QFETCH(double, spacing_m);
    QFETCH(double, limit_m);
    QFETCH(QString, what);
    const auto plan = planCoverage(area, {0, 0}, {spacing_m, limit_m});
    QVERIFY(!plan.has_value());
    QVERIFY2(QString::fromStdString(plan.error().what).contains(what), plan.error().text().c_str());
    QVERIFY(!plan.error().mend.empty());
    QVERIFY(!planCoverage({{0, 0}, {60, 40}}, {qQNaN(), 0}, {10.0}).has_value());
}

USAR_TEST(tst_CoveragePath)

} // namespace tst_coverage_path

#include "tst_coverage_path.moc"
