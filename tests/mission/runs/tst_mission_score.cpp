#include <QTest>

#include <cmath>

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
        QCOMPARE(mission::coverage_pct(mapOver(scanned, 1.0f), field), std::optional(coverage_pct));
    }

    void anEmptyMapCoversNothing() {
        QCOMPARE(score({}, field, nullptr).coverage_pct, 0.0);
        QCOMPARE(score(rasterOver(field, 1.0f), Rectangle{}, nullptr).coverage_pct, 0.0);
        const Rectangle between_centers{{0.01, 0.01}, {0.02, 0.02}};
        QCOMPARE(score(rasterOver(field, 1.0f), between_centers, nullptr).coverage_pct, 0.0);
        QCOMPARE(mission::coverage_pct(mapOver(field, 1.0f), between_centers), std::optional(0.0));
        QVERIFY(!mission::coverage_pct(mapOver(field, 1.0f), Rectangle{}));
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
