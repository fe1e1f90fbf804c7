// What a fast robot knows of the heights ahead, how early it climbs for them, and where it may sink fast.
#include <QObject>
#include <QTest>

#include "robots/airrobot/flight/drape.h"
#include "tests/robots/robot_samples.h"
#include "tests/suite/suite.h"

namespace tst_drape {

using namespace usar;
using namespace usar::airrobot;
using namespace usar::test;

class tst_Drape : public QObject {
    Q_OBJECT

    Settings settings;

    /// A scan from a scanner at this height.
    static void see(HeightAtlas& atlas, double scanner_z_m, const std::vector<Vec3>& hits_m, double below_m = 1e9) {
        Senses senses = sensesAt({0, 0, scanner_z_m});
        senses.scan = PlacedScan{senses.line, senses.base_in_map, senses.base_in_map, hits_m};
        atlas.take(senses, below_m);
    }

private slots:
    void tellsWhatIsInTheCorridor_data() {
        QTest::addColumn<double>("x_m");
        QTest::addColumn<double>("y_m");
        QTest::addColumn<bool>("past");
        QTest::addColumn<bool>("known");
        QTest::newRow("ahead") << 12.5 << 0.5 << false << true;
        QTest::newRow("ahead, seen on an earlier flight") << 12.5 << 0.5 << true << true;
        QTest::newRow("beside it") << 12.5 << 2.5 << false << false;
        QTest::newRow("beside it, where it may have drifted from") << 12.5 << 2.4 << true << true;
        QTest::newRow("far beside it") << 12.5 << 3.5 << true << false;
        QTest::newRow("before its beginning") << 8.5 << 0.5 << false << false;
        QTest::newRow("behind its end") << 15.5 << 0.5 << false << false;
        QTest::newRow("the other way") << -12.5 << 0.5 << false << false;
    }
    void tellsWhatIsInTheCorridor() {
        QFETCH(double, x_m);
        QFETCH(double, y_m);
        QFETCH(bool, past);
        QFETCH(bool, known);
        HeightAtlas atlas;
        see(atlas, 20.0, {Vec3(x_m, y_m, 3.0)});
        if (past)
            atlas.endFlight();
        QCOMPARE(atlas.highest_m({{0, 0}, 0.0, 10.0, 4.0}), known ? std::optional(3.0) : std::nullopt);
        atlas.clear();
        QVERIFY(!atlas.highest_m({{0, 0}, 0.0, 10.0, 4.0}));
    }

    /// A scanner as high as a top does not see what is above it.
    void whatReachesTheScannerGoesOn_data() {
        QTest::addColumn<double>("first_m"); // height of the scanner
        QTest::addColumn<double>("later_m");
        QTest::addColumn<double>("later_hit_m");
        QTest::addColumn<double>("height_m");
        const double more_m = HeightAtlas::hidden_top_m;
        QTest::newRow("seen from above") << 12.0 << 12.0 << 5.0 << 5.0;
        QTest::newRow("at the scanner's height") << 5.2 << 5.2 << 5.0 << 5.0 + more_m;
        QTest::newRow("later its top is seen") << 5.2 << 12.0 << 4.8 << 5.0;
        QTest::newRow("later only its foot is seen") << 5.2 << 12.0 << 1.0 << 5.0 + more_m;
        QTest::newRow("later it is seen to be higher") << 5.2 << 12.0 << 8.0 << 8.0;
    }
    void whatReachesTheScannerGoesOn() {
        QFETCH(double, first_m);
        QFETCH(double, later_m);
        QFETCH(double, later_hit_m);
        QFETCH(double, height_m);
        HeightAtlas atlas;
        see(atlas, first_m, {Vec3(4.5, 0.5, 5.0)});
        see(atlas, later_m, {Vec3(4.6, 0.4, later_hit_m)});
        QCOMPARE(atlas.highest_m({{0, 0}, 0.0, 0.0, 10.0}), std::optional(height_m));
    }

    void theLastFlightKnowsBest() {
        HeightAtlas atlas;
        see(atlas, 20.0, {Vec3(4.5, 0.5, 8.0)});
        atlas.endFlight();
        see(atlas, 20.0, {Vec3(4.5, 0.5, 3.0)});
        QCOMPARE(atlas.highest_m({{0, 0}, 0.0, 0.0, 10.0}), std::optional(3.0));
    }

    void ceilingsAreNoGround() {
        HeightAtlas atlas;
        see(atlas, 2.0, {Vec3(4.5, 0.5, 4.0)}, 3.5);
        QVERIFY(!atlas.highest_m({{0, 0}, 0.0, 0.0, 10.0}));
    }

    /// A top of 10 m, at 2 m/s and 1 m/s of climb: 12 m before it, the robot must be over it, and it climbs 0.4 m/m.
    void climbsInTime_data() {
        QTest::addColumn<double>("away_m");
        QTest::addColumn<double>("speed_m_s");
        QTest::addColumn<double>("straight_m");
        QTest::addColumn<double>("lower_m"); // than over the top; negative: nothing is known on the way
        QTest::newRow("right before it") << 3.0 << 2.0 << 100.0 << 0.0;
        QTest::newRow("at once") << 11.0 << 2.0 << 100.0 << 0.0;
        QTest::newRow("soon") << 21.0 << 2.0 << 100.0 << 3.2;
        QTest::newRow("soon, slowly") << 21.0 << 1.0 << 100.0 << 9.6;
        QTest::newRow("not yet") << 32.0 << 2.0 << 100.0 << -1.0;
        QTest::newRow("it turns before it") << 21.0 << 2.0 << 10.0 << -1.0;
        QTest::newRow("it turns behind it") << 21.0 << 2.0 << 25.0 << 3.2;
    }
    void climbsInTime() {
        QFETCH(double, away_m);
        QFETCH(double, speed_m_s);
        QFETCH(double, straight_m);
        QFETCH(double, lower_m);
        HeightAtlas atlas;
        see(atlas, 20.0, {Vec3(40.5, 0.5, 10.0)});
        const Vec2 here_m(40.5 - away_m, 0.5);
        const auto height_m = drapedHeight_m(atlas, {here_m, 0.0, speed_m_s, straight_m}, settings);
        QCOMPARE(height_m.has_value(), lower_m >= 0.0);
        if (height_m)
            QVERIFY2(std::abs(10.0 + settings.clearance_m - lower_m - *height_m) < 0.01,
                     qPrintable(QString::number(*height_m)));
    }

    void theSteepestOfAllCounts() {
        HeightAtlas atlas;
        see(atlas, 30.0, {Vec3(5.5, 0.5, 2.0), Vec3(25.5, 0.5, 12.0)});
        const auto height_m = drapedHeight_m(atlas, {{0.5, 0.5}, 0.0, 2.0, 100.0}, settings);
        QVERIFY(height_m && *height_m > 2.0 + settings.clearance_m && *height_m < 12.0 + settings.clearance_m);
    }

    void sinksFastWhereTheWayIsKnownOrFarBelow_data() {
        QTest::addColumn<double>("seen_m"); // ahead
        QTest::addColumn<bool>("past");
        QTest::addColumn<double>("height_m");
        QTest::addColumn<bool>("fast");
        QTest::newRow("all of it was seen") << 8.0 << false << 10.0 << true;
        QTest::newRow("all of it was seen on an earlier flight") << 8.0 << true << 10.0 << true;
        QTest::newRow("half of it was seen") << 3.0 << false << 10.0 << false;
        QTest::newRow("nothing was seen") << 0.0 << false << 10.0 << false;
        QTest::newRow("nothing was seen, far above the ground") << 0.0 << false << 17.0 << true;
    }
    void sinksFastWhereTheWayIsKnownOrFarBelow() {
        QFETCH(double, seen_m);
        QFETCH(bool, past);
        QFETCH(double, height_m);
        QFETCH(bool, fast);
        HeightAtlas atlas;
        std::vector<Vec3> hits_m{{-20.0, 0.0, 0.0}};
        for (double x_m = 0.5; x_m < seen_m; x_m += 1.0)
            for (double y_m = -1.5; y_m < 2.0; y_m += 1.0)
                hits_m.emplace_back(x_m, y_m, 1.0);
        see(atlas, 20.0, hits_m);
        if (past)
            atlas.endFlight();
        QCOMPARE(maySinkFast(atlas, {{0, 0}, 0.0, 2.0, 100.0}, height_m), fast);
    }
};

USAR_TEST(tst_Drape)

} // namespace tst_drape

#include "tst_drape.moc"
