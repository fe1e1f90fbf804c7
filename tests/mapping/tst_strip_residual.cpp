#include <QTest>

#include <cmath>
#include <vector>

#include "core/mapping/strip_residual.h"
#include "tests/suite/suite.h"

namespace tst_strip_residual {

using namespace usar::mapping;

namespace {

Overlap overlap(double early, double late, float difference_m) {
    return {.early = early, .late = late, .difference_m = difference_m};
}

} // namespace

class tst_StripResidual : public QObject {
    Q_OBJECT
private slots:
    void countsNoDifferenceAsMoreThanAMeter() {
        const StripResidual residual(std::vector{overlap(0.0, 9.0, 2.5f), overlap(0.0, 9.0, -0.5f)});
        QCOMPARE(residual.overlaps(), std::size_t(2));
        QCOMPARE(*residual.all_m(), std::sqrt((1.0 + 0.25) / 2.0));
        QVERIFY(!StripResidual().all_m());
    }

    void comparesOnlyWhatOverlapsWithBothPaths() {
        const StripResidual before(
            std::vector{overlap(0.1, 9.2, 0.4f), overlap(0.7, 9.9, 0.4f), overlap(3.0, 9.0, 0.0f)});
        const StripResidual after(std::vector{overlap(0.3, 9.5, 0.2f), overlap(5.0, 9.0, 0.9f)});
        const auto compared_m = StripResidual::compared_m(before, after);
        QVERIFY(compared_m);
        QVERIFY(std::abs(compared_m->first - 0.4) < 1e-6 && std::abs(compared_m->second - 0.2) < 1e-6);
        QVERIFY(!StripResidual::compared_m(before, StripResidual(std::vector{overlap(5.0, 9.0, 0.1f)})));
    }

    void weighsPairsOfIntervalsByTheSmallerNumber() {
        const StripResidual before(std::vector{overlap(0.0, 9.0, 0.6f), overlap(1.0, 9.0, 0.2f),
                                               overlap(1.5, 9.0, 0.2f), overlap(1.7, 9.0, 0.2f)});
        const StripResidual after(
            std::vector{overlap(0.0, 9.0, 0.0f), overlap(0.5, 9.0, 0.0f), overlap(1.0, 9.0, 0.1f)});
        const auto compared_m = StripResidual::compared_m(before, after);
        QVERIFY(std::abs(compared_m->first - std::sqrt((0.36 + 0.04) / 2.0)) < 1e-6);
        QVERIFY(std::abs(compared_m->second - std::sqrt(0.01 / 2.0)) < 1e-6);
    }
};

USAR_TEST(tst_StripResidual)

} // namespace tst_strip_residual

#include "tst_strip_residual.moc"
