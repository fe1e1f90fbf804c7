#include <QTest>

#include <cmath>

#include "core/mapping/lag_adjustment.h"
#include "core/mapping/strip_adjustment.h"
#include "tests/mapping/made_up_flight.h"
#include "tests/suite/suite.h"

namespace tst_lag_adjustment {

using namespace usar;
using namespace usar::mapping;
using namespace usar::mapping::made_up;

namespace {

/// How far off scans are placed as they come, root mean square: by the estimates, and by what the lag has found.
struct Placed {
    double estimated_m = 0.0;
    double corrected_m = 0.0;
    PathCorrection correction;
    std::size_t passes = 0;
};

/// Works as a session does, in which parts come between the lines. Counts scans after the first `skipped`, which
/// nothing was seen before.
Placed follow(const MadeUpFlight& flight, std::size_t skipped) {
    FlownStrips flown;
    LagAdjustment adjustment(flown.store);
    Placed placed;
    double estimated_m2 = 0.0, corrected_m2 = 0.0, count = 0.0;
    fly(flight, flown, [&] {
        const Vec3 off_m = flown.store.scans().back().scanner_in_map.position_m - flown.true_in_map_m.back();
        if (flown.true_in_map_m.size() > skipped) {
            estimated_m2 += off_m.squaredNorm();
            corrected_m2 += (off_m - adjustment.newest().error_m).squaredNorm();
            count += 1.0;
        }
        placed.passes += adjustment.step() ? 1 : 0;
    });
    placed.estimated_m = std::sqrt(estimated_m2 / count);
    placed.corrected_m = std::sqrt(corrected_m2 / count);
    placed.correction = adjustment.correction();
    return placed;
}

} // namespace

class tst_LagAdjustment : public QObject {
    Q_OBJECT
private slots:
    /// Waves of the ground look alike, so a single flight may be matched to the wrong one.
    void placesScansBetterInFlight() {
        double estimated_m = 0.0, corrected_m = 0.0;
        for (std::uint64_t seed = 1; seed <= 8; ++seed) {
            const Placed placed = follow({.ground_m = hills, .seed = seed, .lanes = 12}, 450);
            QVERIFY2(placed.corrected_m < 1.3 * placed.estimated_m, qPrintable(QString("seed %1").arg(seed)));
            estimated_m += placed.estimated_m;
            corrected_m += placed.corrected_m;
        }
        QVERIFY2(corrected_m < 0.7 * estimated_m,
                 qPrintable(QString("%1 m estimated, %2 m corrected").arg(estimated_m).arg(corrected_m)));
    }

    /// Passes go on for two minutes after its last one has changed that moment.
    void keepsWhatIsOlderThanTheLag() {
        FlownStrips flown;
        LagAdjustment adjustment(flown.store);
        std::optional<PathKnot> early;
        fly({.ground_m = hills, .lanes = 12}, flown, [&] {
            adjustment.step();
            const Seconds now = flown.store.sorties().back().end;
            if (now > Seconds(230.0) && !early)
                early = adjustment.correction().at(0, Seconds(90.0));
        });
        QVERIFY(early && early->error_m.norm() > 0.0);
        QCOMPARE(adjustment.correction().at(0, Seconds(90.0)).error_m, early->error_m);
        QVERIFY(adjustment.newest().error_m.norm() > 0.0);
    }

    void beginsAfreshWhenTheInsWasSet() {
        FlownStrips flown;
        LagAdjustment adjustment(flown.store);
        fly({.ground_m = hills, .lanes = 8, .lands = true}, flown, [&] { adjustment.step(); });
        QVERIFY(!adjustment.correction().sorties.at(0).empty());
        flown.store.move(Seconds(1000.0), Vec3::Zero());
        QCOMPARE(adjustment.newest().error_m, Vec3(Vec3::Zero()));
        QCOMPARE(adjustment.newest().yaw_error_rad, 0.0);
    }

    void changesNothingWhereTheGroundIsFlat() {
        const Placed placed = follow({.ground_m = plane, .walk_share = 0.08, .lanes = 12}, 0);
        QVERIFY(placed.passes > 0);
        QVERIFY(placed.correction.sorties.empty());
        QCOMPARE(placed.corrected_m, placed.estimated_m);
    }
};

USAR_TEST(tst_LagAdjustment)

} // namespace tst_lag_adjustment

#include "tst_lag_adjustment.moc"
