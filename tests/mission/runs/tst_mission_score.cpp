#include <QTest>

#include <cmath>

#include "core/mapping/area_cells.h"
#include "core/mission/runs/mission_score.h"
#include "tests/suite/suite.h"

namespace tst_mission_score {

using namespace usar;
using namespace usar::mission;

namespace {

/// 0.5 m cells whose centers lie in the rectangle, all at one height.
mapping::HeightMap mapOver(const Rectangle& area, float height_m) {
    mapping::HeightMap map(0.5);
    for (double x = area.min_m.x() + 0.25; x < area.max_m.x(); x += 0.5) {
        for (double y = area.min_m.y() + 0.25; y < area.max_m.y(); y += 0.5)
            map.write(map.cellAt({x, y}), height_m, {1});
    }
    return map;
}

mapping::Raster rasterOver(const Rectangle& area, float height_m) {
    return mapping::rasterOf(mapOver(area, height_m));
}

const Rectangle field{{-10, -5}, {10, 5}};

Truth dividedWorld() {
    const auto reach = [](const Vec2& p) {
        return p.x() > 5.0    ? Reach::OutsideWorld
               : p.x() < -5.0 ? Reach::ShutOff
               : p.y() < 0.0  ? Reach::OverWater
                              : Reach::Scanned;
    };
    return {.surface_m = [](const Vec2&) { return 0.0; },
            .ground_m = [](const Vec2&) { return 0.0; },
            .world_in_map = {{-50, -50}, {5, 50}},
            .reach = [reach](const FlightLimits&, const Rectangle&) { return reach; }};
}

} // namespace

class tst_MissionScore : public QObject {
    Q_OBJECT
private slots:
    void coverageIsTheKnownPartOfTheArea_data() {
        QTest::addColumn<Rectangle>("scanned");
        QTest::addColumn<double>("coverage_pct");
        QTest::newRow("all of it") << field << 100.0;
        QTest::newRow("more than that") << Rectangle{{-30, -30}, {30, 30}} << 100.0;
        QTest::newRow("left half") << Rectangle{{-10, -5}, {0, 5}} << 50.0;
        QTest::newRow("a corner, half outside") << Rectangle{{5, 0}, {15, 10}} << 12.5;
        QTest::newRow("somewhere else") << Rectangle{{50, 50}, {60, 60}} << 0.0;
        QTest::newRow("one cell") << Rectangle{{0, 0}, {0.5, 0.5}} << 100.0 / (40 * 20);
    }

    void coverageIsTheKnownPartOfTheArea() {
        QFETCH(Rectangle, scanned);
        QFETCH(double, coverage_pct);
        QCOMPARE(score(rasterOver(scanned, 1.0f), field, nullptr).coverage_pct, coverage_pct);
        QCOMPARE(mapping::coverage_pct(mapOver(scanned, 1.0f), field), std::optional(coverage_pct));
    }

    void anEmptyMapCoversNothing() {
        QCOMPARE(score({}, field, nullptr).coverage_pct, 0.0);
        QCOMPARE(score(rasterOver(field, 1.0f), Rectangle{}, nullptr).coverage_pct, 0.0);
        const Rectangle between_centers{{0.01, 0.01}, {0.02, 0.02}};
        QCOMPARE(score(rasterOver(field, 1.0f), between_centers, nullptr).coverage_pct, 0.0);
        QCOMPARE(mapping::coverage_pct(mapOver(field, 1.0f), between_centers), std::optional(0.0));
        QVERIFY(!mapping::coverage_pct(mapOver(field, 1.0f), Rectangle{}));
    }

    void withoutATruthThereIsNoRmse() {
        const Score result = score(rasterOver(field, 1.0f), field, nullptr);
        QVERIFY(!result.rmse_m && !result.rmse_surface_m);
        const Truth truth{[](const Vec2&) { return 0.0; }, [](const Vec2&) { return 0.0; }};
        QVERIFY(!score(rasterOver(Rectangle{{50, 50}, {60, 60}}, 1.0f), field, &truth).rmse_m);
    }

    void rmseLooksAtOpenGroundOnly() {
        // The map says 1 m everywhere; the ground lies at 0.9 m and the right half is wood of 5 m.
        const Truth truth{[](const Vec2& p) { return p.x() > 0.0 ? 5.0 : 0.9; }, [](const Vec2&) { return 0.9; }};
        const Score result = score(rasterOver(field, 1.0f), field, &truth);
        QVERIFY(std::abs(result.rmse_m.value() - 0.1) < 1e-9);
        QVERIFY(std::abs(result.rmse_surface_m.value() - std::sqrt((0.01 + 16.0) / 2)) < 1e-9);
    }

    void rmseIsTakenAtTheCellsOfTheArea() {
        mapping::HeightMap map(0.5);
        for (double x = -9.75; x < 20.0; x += 0.5)
            map.write(map.cellAt({x, 2.25}), float(3.0 * x + 2.25), {1});
        const Truth truth{[](const Vec2& p) { return p.x() > 10.0 ? 99.0 : 3.0 * p.x() + p.y(); },
                          [](const Vec2& p) { return p.x() > 10.0 ? 99.0 : 3.0 * p.x() + p.y(); }};
        const Score result = score(mapping::rasterOf(map), field, &truth);
        QVERIFY(result.rmse_m.value() < 1e-5); // at the centers, and nothing of what lies outside
        QCOMPARE(result.coverage_pct, 5.0);
    }

    void whatCannotBeReachedDoesNotCount_data() {
        QTest::addColumn<Rectangle>("scanned");
        QTest::addColumn<double>("reachable_coverage_pct");
        // Of the field, x from -10 to 10 and y from -5 to 5, the world holds x up to 5; x below -5 is shut off, and the
        // lower half of the rest is water.
        QTest::newRow("all of it") << field << 100.0;
        QTest::newRow("what can be reached") << Rectangle{{-5, 0}, {5, 5}} << 100.0;
        QTest::newRow("half of that") << Rectangle{{0, 0}, {5, 5}} << 50.0;
        QTest::newRow("what cannot be reached") << Rectangle{{-10, -5}, {-5, 5}} << 0.0;
    }

    void whatCannotBeReachedDoesNotCount() {
        QFETCH(Rectangle, scanned);
        QFETCH(double, reachable_coverage_pct);
        const auto reach = areaReach(rasterOver(scanned, 1.0f), field, dividedWorld(), {});
        QVERIFY(reach);
        QCOMPARE(reach->coverage_pct, reachable_coverage_pct);
        QCOMPARE(reach->outside_m2, 50.0);
        QCOMPARE(reach->shut_off_m2, 50.0);
        QCOMPARE(reach->water_m2, 50.0);
        QCOMPARE(unreachableNotice(*reach),
                 std::string("75 % of the mission area (150.0 m²) cannot be reached: 50.0 m² are outside the world, "
                             "50.0 m² are inside or behind walls, or under roofs, 50.0 m² are water too deep to "
                             "be scanned."));
    }

    void whereAllCanBeReachedCoverageIsTheSame() {
        Truth truth = dividedWorld();
        truth.world_in_map = {{-50, -50}, {50, 50}};
        truth.reach = [](const FlightLimits&, const Rectangle&) { return [](const Vec2&) { return Reach::Scanned; }; };
        const mapping::Raster raster = rasterOver({{-10, -5}, {3, 4}}, 1.0f);
        const auto reach = areaReach(raster, field, truth, {});
        QVERIFY(reach);
        QCOMPARE(reach->coverage_pct, score(raster, field, nullptr).coverage_pct);
        QCOMPARE(unreachableNotice(*reach), std::string());
    }

    void withoutAnAnswerNothingIsSaidAboutReach() {
        const mapping::Raster raster = rasterOver(field, 1.0f);
        Truth truth = dividedWorld();
        QVERIFY(!areaReach(raster, {{60, 60}, {70, 70}}, truth, {})); // outside the world
        QVERIFY(!areaReach(raster, {}, truth, {}));
        QVERIFY(!areaReach(raster, {{-10, -5}, {-6, 5}}, truth, {})); // all shut off
        truth.reach = [](const FlightLimits&, const Rectangle&) { return ReachMap(); };
        QVERIFY(!areaReach(raster, field, truth, {}));
        truth.reach = {};
        QVERIFY(!areaReach(raster, field, truth, {}));
    }

    void aHugeAreaIsCountedOnlyWithinTheWorld() {
        const Rectangle huge{{-1e5, -1e5}, {1e5, 1e5}};
        const auto reach = areaReach(rasterOver(field, 1.0f), huge, dividedWorld(), {});
        QVERIFY(reach && reach->outside_m2 > 3.9e10);
    }

    void onlyABehaviorWithAScanAltitudeFlies() {
        const Pose start{.position_m = {1, 2, 3}};
        QVERIFY(!flightLimitsOf(start, {}));
        QVERIFY(!flightLimitsOf(start, {{"scan_altitude_m", std::string("high")}}));
        QCOMPARE(flightLimitsOf(start, {{"scan_altitude_m", 4.0}})->maximum_height_m, 4.0);
        QCOMPARE(flightLimitsOf(start, {{"scan_altitude_m", 0.0}, {"ground_resolution_m", 0.25}})->scan_altitude_m,
                 4.0);
        QVERIFY(!flightLimitsOf(start, {{"scan_altitude_m", 0.0}}));
        std::map<std::string, agent::ParameterValue> parameters{
            {"scan_altitude_m", 4.0}, {"maximum_height_m", 15.0}, {"climb_over", true}};
        const auto flight = flightLimitsOf(start, parameters);
        QVERIFY(flight && flight->start_in_map_m == start.position_m && flight->scan_altitude_m == 4.0);
        QCOMPARE(flight->maximum_height_m, 15.0);
        parameters["climb_over"] = false;
        QCOMPARE(flightLimitsOf(start, parameters)->maximum_height_m, 4.0);
    }

    void aTruthThatEndsSomewhereIsLeftOut() {
        const Truth truth{[](const Vec2& p) { return p.y() > 0.0 ? qQNaN() : 0.5; }, [](const Vec2&) { return 0.5; }};
        const Score result = score(rasterOver(field, 1.0f), field, &truth);
        QVERIFY(std::abs(result.rmse_m.value() - 0.5) < 1e-9);
        QVERIFY(std::abs(result.rmse_surface_m.value() - 0.5) < 1e-9);
    }
};

USAR_TEST(tst_MissionScore)

} // namespace tst_mission_score

#include "tst_mission_score.moc"
