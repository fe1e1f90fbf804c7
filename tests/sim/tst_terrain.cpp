#include "core/sim/world/terrain.h"

#include <QObject>
#include <QTest>

#include "tests/doubles/test_worlds.h"
#include "tests/suite/suite.h"

namespace tst_terrain {

using usar::Vec2;
using usar::sim::Terrain;

namespace {

// Two columns of cells: posts (x, y) = (10, 20), (12, 20), (14, 20) below, then y = 22.
Terrain twoCells() {
    return Terrain(3, 2, 2.0, Vec2{10.0, 20.0}, {0.0f, 1.0f, 3.0f, 4.0f, 8.0f, -2.0f});
}

} // namespace

class tst_Terrain : public QObject {
    Q_OBJECT

private slots:
    void heightIsThatOfTheTriangleUnderThePoint_data() {
        QTest::addColumn<double>("x_m");
        QTest::addColumn<double>("y_m");
        QTest::addColumn<double>("height_m");
        QTest::newRow("middle of the first cell lies on the diagonal 0 to 8") << 11.0 << 21.0 << 4.0;
        QTest::newRow("right of the diagonal: posts 0, 1, 8") << 11.5 << 20.5 << 0.75 * 1.0 + 0.25 * 7.0;
        QTest::newRow("left of the diagonal: posts 0, 4, 8") << 10.5 << 21.5 << 0.75 * 4.0 + 0.25 * 4.0;
        QTest::newRow("second cell, diagonal 1 to -2") << 13.0 << 21.0 << -0.5;
        QTest::newRow("lower edge") << 13.0 << 20.0 << 2.0;
    }
    void heightIsThatOfTheTriangleUnderThePoint() {
        QFETCH(double, x_m);
        QFETCH(double, y_m);
        QFETCH(double, height_m);
        QVERIFY(std::abs(twoCells().height_m({x_m, y_m}) - height_m) < 1e-12);
    }

    void postsKeepTheirHeights() {
        const Terrain terrain = usar::doubles::roughWorld(5, 9).terrain;
        for (std::size_t row = 0; row < terrain.rows(); ++row)
            for (std::size_t column = 0; column < terrain.columns(); ++column) {
                const Vec2 at_m =
                    terrain.origin_m() + terrain.step_m() * Vec2{static_cast<double>(column), static_cast<double>(row)};
                QVERIFY(std::abs(terrain.height_m(at_m) - static_cast<double>(terrain.post_m(column, row))) < 1e-12);
            }
    }

    void heightIsContinuousAcrossCells() {
        const Terrain terrain = usar::doubles::roughWorld(6, 9).terrain;
        const double steepest = 2.0 * 4.0 / terrain.step_m();
        usar::Random random = usar::seeded(6, 0);
        for (int i = 0; i < 2000; ++i) {
            const Vec2 a{usar::uniform(random, -2.0, 2.0), usar::uniform(random, -2.0, 2.0)};
            const Vec2 b = a + Vec2{usar::uniform(random, -1e-3, 1e-3), usar::uniform(random, -1e-3, 1e-3)};
            QVERIFY(std::abs(terrain.height_m(a) - terrain.height_m(b)) <= steepest * (a - b).norm() + 1e-12);
        }
    }

    void pointsOutsideTakeTheBorder_data() {
        QTest::addColumn<double>("x_m");
        QTest::addColumn<double>("y_m");
        QTest::addColumn<double>("height_m");
        QTest::newRow("far west and south") << -1000.0 << -1000.0 << 0.0;
        QTest::newRow("far east and north") << 1e9 << 1e9 << -2.0;
        QTest::newRow("west of a left edge") << 0.0 << 21.0 << 2.0;
        QTest::newRow("north of an upper edge") << 13.0 << 50.0 << 3.0;
    }
    void pointsOutsideTakeTheBorder() {
        QFETCH(double, x_m);
        QFETCH(double, y_m);
        QFETCH(double, height_m);
        QVERIFY(std::abs(twoCells().height_m({x_m, y_m}) - height_m) < 1e-12);
    }

    void extentSpansTheOuterPosts() {
        const usar::Rectangle expected{{10.0, 20.0}, {14.0, 22.0}};
        QCOMPARE(twoCells().extent(), expected);
    }

    void knowsLowestAndHighestPost() {
        QCOMPARE(twoCells().minimum_m(), -2.0f);
        QCOMPARE(twoCells().maximum_m(), 8.0f);
    }

    void anEmptyTerrainIsFlatAndHasNoExtent() {
        const Terrain terrain;
        QVERIFY(terrain.empty());
        QVERIFY(terrain.extent().empty());
        QCOMPARE(terrain.height_m({3.0, 4.0}), 0.0);
    }

    void aLevelFloorHasTheFewestSquarePosts_data() {
        QTest::addColumn<double>("width_m");
        QTest::addColumn<double>("depth_m");
        QTest::addColumn<int>("columns");
        QTest::addColumn<int>("rows");
        QTest::newRow("a square") << 7.0 << 7.0 << 2 << 2;
        QTest::newRow("twice as wide as deep") << 8.0 << 4.0 << 3 << 2;
        QTest::newRow("twice as deep as wide") << 4.0 << 8.0 << 2 << 3;
        QTest::newRow("two to three") << 12.0 << 8.0 << 4 << 3;
        QTest::newRow("tenths") << 0.7 << 0.3 << 8 << 4;
    }
    void aLevelFloorHasTheFewestSquarePosts() {
        QFETCH(double, width_m);
        QFETCH(double, depth_m);
        QFETCH(int, columns);
        QFETCH(int, rows);
        const auto floor = Terrain::level({Vec2{-1.0, 2.0}, Vec2{-1.0 + width_m, 2.0 + depth_m}}, 1.5);
        QVERIFY(floor);
        QCOMPARE(floor->columns(), static_cast<std::size_t>(columns));
        QCOMPARE(floor->rows(), static_cast<std::size_t>(rows));
        QVERIFY(floor->extent().max_m.isApprox(Vec2{-1.0 + width_m, 2.0 + depth_m}, 1e-9));
        QCOMPARE(floor->minimum_m(), 1.5f);
        QCOMPARE(floor->maximum_m(), 1.5f);
    }

    void noFloorWithoutACommonMeasure_data() {
        QTest::addColumn<double>("width_m");
        QTest::addColumn<double>("depth_m");
        QTest::newRow("no width") << 0.0 << 1.0;
        QTest::newRow("less than no depth") << 1.0 << -1.0;
        QTest::newRow("a circle's side") << usar::pi << 1.0;
        QTest::newRow("a line") << 100000.0 << 1.0;
        QTest::newRow("not a number") << std::nan("") << 1.0;
    }
    void noFloorWithoutACommonMeasure() {
        QFETCH(double, width_m);
        QFETCH(double, depth_m);
        QVERIFY(!Terrain::level({Vec2::Zero(), Vec2{width_m, depth_m}}, 0.0));
    }
};

USAR_TEST(tst_Terrain)

} // namespace tst_terrain

#include "tst_terrain.moc"
