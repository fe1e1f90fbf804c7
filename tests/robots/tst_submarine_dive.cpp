#include "tests/robots/dive_trial.h"
#include "tests/suite/suite.h"

namespace tst_submarine_dive {

using namespace usar;
using namespace usar::test;

namespace {

/// A round plateau 6.5 m under water, and around it a bottom that lies deeper by `drop_m`.
sim::World plateauInTheSea(double drop_m) {
    constexpr double radius_m = 25.0;
    sim::World world;
    world.name = "plateau";
    world.terrain = sim::terrainOf({.columns = 401, .rows = 401, .step_m = 1.0, .steps_per_m = 512.0},
                                   [=](const Vec2& at_m) { return at_m.norm() < radius_m ? -6.5 : -6.5 - drop_m; });
    world.water = sim::Water{.surface_z_m = 0.0, .density_kg_m3 = 1025.0};
    return world;
}

/// Level 14 m under water, and from x = 0 on a coast.
sim::World coastInTheSea(double slope) {
    sim::World world;
    world.name = "coast";
    world.terrain = sim::terrainOf({.columns = 401, .rows = 401, .step_m = 1.0, .steps_per_m = 512.0},
                                   [=](const Vec2& at_m) { return -14.0 + std::clamp(slope * at_m.x(), 0.0, 18.0); });
    world.water = sim::Water{.surface_z_m = 0.0, .density_kg_m3 = 1025.0};
    return world;
}

Dive diveOverTheCliff(double drop_m, bool knows_slant, double from_x_m = 18.0) {
    return dive(plateauInTheSea(drop_m), Pose{{from_x_m, 0.0, 1.0}}, 1, Seconds(150.0),
                {{"knows_slant", knows_slant}, {"propeller_pct", 100.0}});
}

} // namespace

class tst_SubmarineDive : public QObject {
    Q_OBJECT

private slots:
    void theThesissRuleHitsTheBottomBehindACliff_data() { drops(); }
    void theThesissRuleHitsTheBottomBehindACliff() {
        QFETCH(double, drop_m);
        const Dive dived = diveOverTheCliff(drop_m, false);
        QVERIFY(dived.truth.collisions > 0);
        QVERIFY2(dived.steepest_rad > radians(30.0), "its ray was nearly plumb, so the trial tries nothing");
    }

    void knowingItsSlantItDoesNot_data() { drops(); }
    void knowingItsSlantItDoesNot() {
        QFETCH(double, drop_m);
        const Dive dived = diveOverTheCliff(drop_m, true);
        QCOMPARE(dived.truth.collisions, 0);
        QVERIFY(dived.least_m > 2.0);
        QVERIFY(dived.steepest_rad < radians(25.0));
        QVERIFY(dived.truth.base_in_map.position_m.z() < -6.5 - drop_m + 5.5); // it went down there
    }

    void goesBackWhereTheBottomFallsOutOfReach() {
        const Dive dived = diveOverTheCliff(40.0, true, -20.0);
        QVERIFY(dived.ending && dived.ending->success);
        QCOMPARE(dived.truth.collisions, 0);
        QVERIFY(dived.truth.base_in_map.position_m.head<2>().norm() < 60.0);
        QVERIFY(dived.truth.base_in_map.position_m.z() > -6.5);
    }

    /// A steep coast rises before its nose, where its ray does not look: of a bottom 14 m deep up to the surface.
    void staysOffASteepCoast_data() {
        QTest::addColumn<double>("slope");
        for (const double slope : {0.4, 0.6, 0.8})
            QTest::addRow("that rises %g m a meter", slope) << slope;
    }
    void staysOffASteepCoast() {
        QFETCH(double, slope);
        const Dive dived = dive(coastInTheSea(slope), Pose{{-25.0, 0.0, 1.0}}, 1, Seconds(400.0));
        QVERIFY(dived.ending && dived.ending->success);
        QCOMPARE(dived.truth.collisions, 0);
    }

    void divesFromTheSurface() {
        const Dive dived = dive(plateauInTheSea(8.0), Pose{{40.0, 0.0, -0.1}}, 1, Seconds(120.0));
        QCOMPARE(dived.truth.collisions, 0);
        QVERIFY(dived.truth.base_in_map.position_m.z() < -6.0);
    }

    void followsTheBottomOfTheSea_data() {
        QTest::addColumn<int>("seed");
        QTest::newRow("open sea") << 1;
        QTest::newRow("north sea") << 2;
        QTest::newRow("bay") << 3;
    }
    void followsTheBottomOfTheSea() {
        QFETCH(int, seed);
        const Dive dived = diveInTheSea(static_cast<std::uint64_t>(seed), Seconds(600.0));
        QVERIFY(dived.ending && dived.ending->success);
        QCOMPARE(dived.truth.collisions, 0);
        QVERIFY(dived.rms_error_m < 1.2);
        QVERIFY(dived.share_near_pct > 85.0);
        QVERIFY(dived.least_m > 0.3);
        QVERIFY(dived.truth.distance_m > 300.0);
    }

private:
    static void drops() {
        QTest::addColumn<double>("drop_m");
        for (const double drop_m : {4.0, 8.0, 14.0})
            QTest::addRow("of %g m", drop_m) << drop_m;
    }
};

USAR_TEST(tst_SubmarineDive)

} // namespace tst_submarine_dive

#include "tst_submarine_dive.moc"
