#include <QTest>

#include <cmath>

#include "core/mapping/map_rebuild.h"
#include "core/mapping/strip_adjustment.h"
#include "tests/mapping/made_up_flight.h"
#include "tests/suite/suite.h"

Q_DECLARE_METATYPE(usar::mapping::made_up::Ground)
Q_DECLARE_METATYPE(usar::mapping::AdjustmentVerdict)

namespace tst_strip_adjustment {

using namespace usar;
using namespace usar::mapping;
using namespace usar::mapping::made_up;

namespace {

double bowl(double x_m, double y_m) {
    return 0.012 * ((x_m - 15.0) * (x_m - 15.0) + (y_m - 9.0) * (y_m - 9.0)) - 3.0;
}
double valley(double, double y_m) {
    return std::sin(0.6 * y_m);
}
double incline(double x_m, double y_m) {
    return 0.2 * x_m - 0.1 * y_m;
}

StripResult adjust(const ScanStore& store) {
    StripAdjustment adjustment(store);
    while (adjustment.step()) {
    }
    return adjustment.result();
}

Vec3 nothing(const KeptScan&) {
    return Vec3::Zero();
}

/// Root mean square of the differences of a map's heights from the ground.
double mapError_m(const ScanStore& store, const PathCorrection& correction, const Ground& ground_m) {
    MapRebuild rebuild(store, correction, HeightMap(0.25));
    while (rebuild.step()) {
    }
    const HeightMap map = rebuild.takeMap();
    double sum_m2 = 0.0, cells = 0.0;
    for (const GridIndex& index : map.tileIndices())
        for (std::int32_t at = 0; at < HeightTile::side * HeightTile::side; ++at) {
            const GridIndex cell{index.column * HeightTile::side + at % HeightTile::side,
                                 index.row * HeightTile::side + at / HeightTile::side};
            const auto height_m = map.height_m(cell);
            if (!height_m)
                continue;
            const Vec2 center_m = map.center_m(cell);
            sum_m2 += std::pow(double(*height_m) - ground_m(center_m.x(), center_m.y()), 2);
            cells += 1.0;
        }
    return std::sqrt(sum_m2 / cells);
}

QByteArray rowName(const char* what, int seed) {
    return QByteArray(what) + ", seed " + QByteArray::number(seed);
}

} // namespace

class tst_StripAdjustment : public QObject {
    Q_OBJECT
private slots:
    void findsTheDriftWhereTheGroundGivesHold_data() {
        QTest::addColumn<Ground>("ground_m");
        QTest::addColumn<int>("seed");
        for (int seed = 1; seed <= 2; ++seed) {
            QTest::newRow(rowName("a bowl", seed)) << Ground(bowl) << seed;
            QTest::newRow(rowName("hills", seed)) << Ground(hills) << seed;
        }
    }
    void findsTheDriftWhereTheGroundGivesHold() {
        QFETCH(Ground, ground_m);
        QFETCH(int, seed);
        const FlownStrips flown = fly({.ground_m = ground_m, .walk_share = 0.08, .seed = std::uint64_t(seed)});
        const StripResult result = adjust(flown.store);
        QVERIFY2(result.verdict == AdjustmentVerdict::Adjusted, result.reason.c_str());
        QVERIFY(*result.residual_after_m < 0.6 * *result.residual_before_m);
        const Vec3 before_m = flown.left_m(nothing);
        const Vec3 after_m =
            flown.left_m([&](const KeptScan& scan) { return result.correction.at(scan.sortie, scan.time).error_m; });
        QVERIFY2(after_m.norm() < 0.6 * before_m.norm(),
                 qPrintable(QString("%1 m before, %2 m after").arg(before_m.norm()).arg(after_m.norm())));
        QVERIFY(mapError_m(flown.store, result.correction, ground_m) < mapError_m(flown.store, {}, ground_m));
    }

    void findsTheErrorOfTheYaw_data() {
        QTest::addColumn<int>("seed");
        for (int seed = 1; seed <= 3; ++seed)
            QTest::newRow(rowName("hills", seed)) << seed;
    }
    void findsTheErrorOfTheYaw() {
        QFETCH(int, seed);
        const double error_rad = 0.04;
        const FlownStrips flown = fly({.ground_m = hills,
                                       .walk_share = 0.02,
                                       .seed = std::uint64_t(seed),
                                       .lanes = 6,
                                       .yaw_error_rad = error_rad});
        const StripResult result = adjust(flown.store);
        QVERIFY2(result.verdict == AdjustmentVerdict::Adjusted, result.reason.c_str());
        double sum_rad2 = 0.0;
        for (const KeptScan& scan : flown.store.scans()) {
            const double is_rad = result.correction.at(scan.sortie, scan.time).yaw_error_rad;
            const double true_rad = std::cos(scan.scanner_in_map.yaw_rad) > 0.0 ? error_rad : -error_rad;
            sum_rad2 += std::pow(is_rad - true_rad, 2);
        }
        const double left_rad = std::sqrt(sum_rad2 / double(flown.store.scans().size()));
        QVERIFY2(left_rad < 0.6 * error_rad, qPrintable(QString::number(left_rad)));
    }

    void adjustsStripsThatOverlapOnlyOnceThePathIsBridged_data() {
        QTest::addColumn<double>("walk_share");
        QTest::addColumn<AdjustmentVerdict>("verdict");
        QTest::newRow("bridging is enough") << 0.0 << AdjustmentVerdict::Bridged;
        QTest::newRow("bridging leaves errors") << 0.12 << AdjustmentVerdict::Adjusted;
    }
    void adjustsStripsThatOverlapOnlyOnceThePathIsBridged() {
        QFETCH(double, walk_share);
        QFETCH(AdjustmentVerdict, verdict);
        const FlownStrips flown = fly({.ground_m = hills,
                                       .walk_share = walk_share,
                                       .spacing_m = 8.0,
                                       .height_m = 4.0,
                                       .lands = true,
                                       .creep = 0.25,
                                       .sidles = true});
        const StripResult result = adjust(flown.store);
        QVERIFY2(result.verdict == verdict, result.reason.c_str());
        QVERIFY(result.overlaps < 200);
        const auto corrected = [&](const KeptScan& scan) {
            return result.correction.at(scan.sortie, scan.time).error_m;
        };
        QVERIFY(flown.left_m(corrected).norm() < 0.1 * flown.left_m(nothing).norm());
    }

    void adjustsAreasOfMoreThanASquareKilometer() {
        FlownStrips flown = fly({.ground_m = hills, .walk_share = 0.08});
        KeptScan far = flown.store.scans().front();
        far.scanner_in_map.position_m += Vec3(1100.0, 1100.0, 0.0);
        flown.store.keep(far);
        const StripResult result = adjust(flown.store);
        QVERIFY2(result.verdict == AdjustmentVerdict::Adjusted, result.reason.c_str());
    }

    void declinesIfTheRobotKnowsWhereItIs() {
        FlownStrips flown = fly({.ground_m = hills, .walk_share = 0.08, .lands = true});
        flown.store.setExact(true);
        const StripResult result = adjust(flown.store);
        QCOMPARE(result.verdict, AdjustmentVerdict::Declined);
        QCOMPARE(result.reason, std::string("The robot knew where it was, so its path has no errors."));
    }

    void declinesWhereTheGroundGivesNone_data() {
        QTest::addColumn<Ground>("ground_m");
        QTest::addColumn<int>("seed");
        for (int seed = 1; seed <= 2; ++seed) {
            QTest::newRow(rowName("a plane", seed)) << Ground(plane) << seed;
            QTest::newRow(rowName("an inclined plane", seed)) << Ground(incline) << seed;
        }
    }
    void declinesWhereTheGroundGivesNone() {
        QFETCH(Ground, ground_m);
        QFETCH(int, seed);
        const FlownStrips flown = fly({.ground_m = ground_m, .seed = std::uint64_t(seed)});
        const StripResult result = adjust(flown.store);
        QCOMPARE(result.verdict, AdjustmentVerdict::Declined);
        QCOMPARE(result.reason, std::string("The ground is too flat to tell where a strip lies."));
        QVERIFY(result.correction.sorties.empty());
        QCOMPARE(result.residual_after_m, result.residual_before_m);
        QVERIFY(result.overlaps > 1000);
    }

    void leavesADirectionAloneThatTheGroundDoesNotHold_data() {
        QTest::addColumn<int>("seed");
        for (int seed = 1; seed <= 2; ++seed)
            QTest::newRow(rowName("a valley", seed)) << seed;
    }
    void leavesADirectionAloneThatTheGroundDoesNotHold() {
        QFETCH(int, seed);
        const FlownStrips flown = fly({.ground_m = valley, .walk_share = 0.08, .seed = std::uint64_t(seed)});
        const StripResult result = adjust(flown.store);
        QVERIFY2(result.verdict == AdjustmentVerdict::Adjusted, result.reason.c_str());
        QVERIFY2(result.reason.ends_with("The ground holds one horizontal direction only."), result.reason.c_str());
        const PathKnot& last = result.correction.sorties.at(0).back();
        QVERIFY(last.sigma_m.x() > 1.3 * last.sigma_m.y());
        const Vec3 before_m = flown.left_m(nothing);
        const Vec3 after_m =
            flown.left_m([&](const KeptScan& scan) { return result.correction.at(scan.sortie, scan.time).error_m; });
        QVERIFY2(after_m.x() < 1.1 * before_m.x(), qPrintable(QString::number(after_m.x())));
        QVERIFY2(after_m.y() < 0.6 * before_m.y(), qPrintable(QString::number(after_m.y())));
    }

    void neverMakesAMapWorseThatHasNoDrift_data() {
        QTest::addColumn<Ground>("ground_m");
        QTest::addColumn<int>("seed");
        for (int seed = 1; seed <= 2; ++seed) {
            QTest::newRow(rowName("a bowl", seed)) << Ground(bowl) << seed;
            QTest::newRow(rowName("hills", seed)) << Ground(hills) << seed;
            QTest::newRow(rowName("a valley", seed)) << Ground(valley) << seed;
            QTest::newRow(rowName("a plane", seed)) << Ground(plane) << seed;
        }
    }
    void neverMakesAMapWorseThatHasNoDrift() {
        QFETCH(Ground, ground_m);
        QFETCH(int, seed);
        const FlownStrips flown =
            fly({.ground_m = ground_m, .walk_share = 0.0, .noise_m = 0.02 * (seed % 3), .seed = std::uint64_t(seed)});
        const StripResult result = adjust(flown.store);
        const double before_m = mapError_m(flown.store, {}, ground_m);
        const double after_m = mapError_m(flown.store, result.correction, ground_m);
        QVERIFY2(after_m <= before_m + 1e-3, qPrintable(QString("%1 m, was %2 m: ").arg(after_m).arg(before_m) +
                                                        QString::fromStdString(result.reason)));
    }

    void correctsByTheSettingOfTheInsAloneOverFlatGround() {
        const FlownStrips flown = fly({.ground_m = plane, .walk_share = 0.1, .lands = true});
        const StripResult result = adjust(flown.store);
        QCOMPARE(result.verdict, AdjustmentVerdict::Bridged);
        QVERIFY(result.reason.starts_with("The ground is too flat"));
        QVERIFY(*result.residual_after_m <= *result.residual_before_m);
        const Vec3 closing_m = *flown.store.sorties().at(0).closing_error_m;
        const std::vector<PathKnot>& knots = result.correction.sorties.at(0);
        QVERIFY((knots.back().error_m - closing_m).norm() < 0.05);
        QVERIFY(knots.front().error_m.norm() < 0.05);
        QVERIFY(knots.at(knots.size() / 2).sigma_m.x() > 2.0 * knots.front().sigma_m.x());
    }

    void isNotBridgedByAFlightWithoutScans() {
        FlownStrips flown = fly({.ground_m = plane, .lanes = 0, .lands = true});
        flown.store.move(Seconds(100.0), Vec3::Zero());
        flown.store.insWasSet(Vec3::Ones(), Vec3::Zero());
        flown.store.move(Seconds(101.0), Vec3::Zero());
        flown.store.keep(fly({.ground_m = plane}).store.scans().front());
        QCOMPARE(adjust(flown.store).verdict, AdjustmentVerdict::Declined);
    }

    void saysWhyItHasNothingToWorkOn_data() {
        QTest::addColumn<int>("lanes");
        QTest::addColumn<double>("spacing_m");
        QTest::addColumn<QString>("reason");
        QTest::newRow("no scans") << 0 << 6.0 << "There are no scans.";
        QTest::newRow("one lane") << 1 << 6.0 << "Hardly any ground was seen twice, half a minute apart.";
        QTest::newRow("lanes that do not overlap")
            << 3 << 60.0 << "Hardly any ground was seen twice, half a minute apart.";
    }
    void saysWhyItHasNothingToWorkOn() {
        QFETCH(int, lanes);
        QFETCH(double, spacing_m);
        QFETCH(QString, reason);
        const FlownStrips flown = fly({.ground_m = hills, .lanes = lanes, .spacing_m = spacing_m});
        const StripResult result = adjust(flown.store);
        QCOMPARE(result.verdict, AdjustmentVerdict::Declined);
        QCOMPARE(QString::fromStdString(result.reason), reason);
    }

    void givesEqualResultsForEqualScans() {
        const FlownStrips flown = fly({.ground_m = hills});
        const StripResult a = adjust(flown.store), b = adjust(flown.store);
        QVERIFY(a.verdict == b.verdict && a.residual_after_m == b.residual_after_m);
        for (std::size_t knot = 0; knot < a.correction.sorties.at(0).size(); ++knot) {
            QCOMPARE(a.correction.sorties[0][knot].error_m, b.correction.sorties[0][knot].error_m);
            QCOMPARE(a.correction.sorties[0][knot].sigma_m, b.correction.sorties[0][knot].sigma_m);
        }
    }

    void isNotImpressedByGarbledPositions() {
        FlownStrips flown = fly({.ground_m = hills});
        KeptScan stray = flown.store.scans().front();
        stray.scanner_in_map.position_m = {1e9, -1e9, 6.0};
        flown.store.keep(stray);
        stray.scanner_in_map.position_m.x() = std::nan("");
        flown.store.keep(stray);
        QCOMPARE(adjust(flown.store).verdict, AdjustmentVerdict::Adjusted);
    }
};

USAR_TEST(tst_StripAdjustment)

} // namespace tst_strip_adjustment

#include "tst_strip_adjustment.moc"
