#include <QTest>

#include "core/campaign/comparison/coverage_band.h"
#include "tests/campaign/comparison/example_runs.h"
#include "tests/suite/suite.h"

namespace tst_coverage_band {

using namespace usar;
using namespace usar::campaign;

namespace {

RunFigures growing(std::vector<QPointF> coverage) {
    RunFigures run = test::run("old", 0);
    run.course.coverage = std::move(coverage);
    return run;
}

} // namespace

class tst_CoverageBand : public QObject {
    Q_OBJECT
private slots:
    void aRunGrowsEvenlyAndKeepsWhatItHas_data() {
        QTest::addColumn<int>("step"); // of ten seconds
        QTest::addColumn<double>("covered_pct");
        QTest::newRow("before its first point") << 0 << 0.0;
        QTest::newRow("at a point") << 1 << 20.0;
        QTest::newRow("between two") << 2 << 40.0;
        QTest::newRow("at its end") << 3 << 60.0;
        QTest::newRow("after its end") << 4 << 60.0;
    }

    void aRunGrowsEvenlyAndKeepsWhatItHas() {
        QFETCH(int, step);
        QFETCH(double, covered_pct);
        const RunFigures run = growing({{5.0, 0.0}, {10.0, 20.0}, {30.0, 60.0}});
        const auto band = coverageBand({&run}, 40.0, 4);
        QCOMPARE(band.size(), std::size_t(5));
        QCOMPARE(band[std::size_t(step)].elapsed_s, 10.0 * step);
        QCOMPARE(band[std::size_t(step)].median_pct, covered_pct);
        QCOMPARE(lastCoverage_s({&run}), 30.0);
    }

    void theBandLeavesOutATenthOnEachSide() {
        std::vector<RunFigures> runs;
        for (int i = 0; i <= 100; ++i)
            runs.push_back(growing({{0.0, double(i)}, {10.0, double(i)}}));
        runs.push_back(growing({})); // It does not tell.
        std::vector<const RunFigures*> all;
        for (const RunFigures& run : runs)
            all.push_back(&run);
        const CoverageSpread spread = coverageBand(all, 10.0).front();
        QCOMPARE(spread.tenth_pct, 10.0);
        QCOMPARE(spread.median_pct, 50.0);
        QCOMPARE(spread.ninetieth_pct, 90.0);
    }

    void nothingIsShownOfRunsThatDoNotTell() {
        const RunFigures run = growing({});
        QVERIFY(coverageBand({&run}, 10.0).empty());
        QCOMPARE(lastCoverage_s({&run}), 0.0);
    }
};

USAR_TEST(tst_CoverageBand)

} // namespace tst_coverage_band

#include "tst_coverage_band.moc"
