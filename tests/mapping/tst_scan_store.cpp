#include <QTest>

#include <cmath>
#include <cstring>

#include "core/mapping/deviation.h"
#include "core/mapping/map_rebuild.h"
#include "core/mapping/sparse_inverse.h"
#include "tests/mapping/made_up_flight.h"
#include "tests/suite/suite.h"

namespace tst_scan_store {

using namespace usar;
using namespace usar::mapping;

class tst_ScanStore : public QObject {
    Q_OBJECT
private slots:
    void startsASortieWhenTheInsIsSet() {
        ScanStore store;
        store.move(Seconds(10.0), {0.0, 0.0, 0.0});
        store.move(Seconds(11.0), {3.0, 0.0, 4.0});
        store.insWasSet({3.0, 0.0, 4.0}, {2.5, 0.0, 4.0});
        store.move(Seconds(20.0), {2.5, 0.0, 4.0});
        store.move(Seconds(21.0), {2.5, 1.0, 4.0});
        QCOMPARE(store.sorties().size(), std::size_t(2));
        QCOMPARE(store.sorties()[0].walk_m2, 25.0);
        QCOMPARE(*store.sorties()[0].closing_error_m, Vec3(0.5, 0.0, 0.0));
        QCOMPARE(store.sorties()[1].begin, Seconds(20.0));
        QCOMPARE(store.sorties()[1].walk_m2, 1.0);
        QVERIFY(!store.sorties()[1].closing_error_m);
    }

    void keepsAClockThatNeverRunsBackward() {
        ScanStore store;
        store.move(Seconds(100.0), Vec3::Zero());
        store.interrupt();
        store.move(Seconds(5.0), Vec3::Ones());
        QCOMPARE(store.sorties().size(), std::size_t(2));
        QVERIFY(store.sorties()[1].begin > store.sorties()[0].end);
        QCOMPARE(store.sorties()[1].walk_m2, 0.0);
        QVERIFY(!store.sorties()[0].closing_error_m);
        store.move(Seconds(6.0), Vec3::Ones());
        QCOMPARE(store.sorties()[1].end - store.sorties()[1].begin, Seconds(1.0));
    }

    void keepsNothingWithoutAnEstimate() {
        ScanStore store;
        store.keep({.ranges_m = {1.0f}});
        store.move(Seconds(1.0), Vec3::Zero());
        store.insWasSet(Vec3::Zero(), Vec3::Zero());
        store.keep({.ranges_m = {1.0f}});
        QVERIFY(store.scans().empty());
    }

    void forgetsEverythingAboveItsLimit() {
        ScanStore store;
        store.move(Seconds(1.0), Vec3::Zero());
        const std::vector<float> ranges_m(std::size_t(1) << 20, 1.0f);
        int kept = 0;
        for (; !store.overfull() && kept < 100; ++kept)
            store.keep({.ranges_m = ranges_m});
        QCOMPARE(kept, 64); // of 4 MB each
        QVERIFY(store.scans().empty());
        QCOMPARE(store.memoryBytes(), std::size_t(0));
        store.keep({.ranges_m = {1.0f}});
        QVERIFY(store.scans().empty());
        store.clear();
        QVERIFY(!store.overfull());
    }

    void interpolatesErrorsBetweenKnots_data() {
        QTest::addColumn<int>("sortie");
        QTest::addColumn<double>("time_s");
        QTest::addColumn<double>("x_m");
        QTest::newRow("before the first") << 0 << 5.0 << 1.0;
        QTest::newRow("at the first") << 0 << 10.0 << 1.0;
        QTest::newRow("between") << 0 << 11.0 << 1.5;
        QTest::newRow("at a knot") << 0 << 14.0 << 3.0;
        QTest::newRow("after the last") << 0 << 99.0 << 3.0;
        QTest::newRow("in a sortie without knots") << 1 << 11.0 << 0.0;
        QTest::newRow("in an unknown sortie") << 7 << 11.0 << 0.0;
    }
    void interpolatesErrorsBetweenKnots() {
        QFETCH(int, sortie);
        QFETCH(double, time_s);
        QFETCH(double, x_m);
        const PathCorrection correction{
            {{{Seconds(10.0), Vec3(1.0, 0.0, 0.0), Vec3::Zero()}, {Seconds(14.0), Vec3(3.0, 0.0, 0.0), Vec3::Zero()}},
             {}}};
        QCOMPARE(correction.at(std::size_t(sortie), Seconds(time_s)).error_m.x(), x_m);
    }

    void knowsTheSameCellsAgainWithoutACorrection() {
        const auto flown =
            made_up::fly({.ground_m = [](double x_m, double) { return 0.1 * x_m; }, .walk_share = 0.0, .lanes = 2});
        HeightMap written(0.25);
        ScanIntegrator integrator;
        std::vector<double> ranges_m;
        for (const KeptScan& scan : flown.store.scans()) {
            if (!scan.continues)
                integrator.breakStrip();
            integrator.integrate(scan.beams(ranges_m), scan.scanner_in_map, scan.line, written);
        }
        MapRebuild rebuild(flown.store, {}, HeightMap(0.25));
        int steps = 1;
        while (rebuild.step())
            ++steps;
        const HeightMap again = rebuild.takeMap();
        QCOMPARE(steps, 4); // for 300 scans, twice
        QCOMPARE(again.knownCellCount(), written.knownCellCount());
        for (const GridIndex& index : written.tileIndices())
            for (std::size_t at = 0; at < HeightTile::cell_count; ++at) {
                const HeightTile &is = *again.tile(index), &was = *written.tile(index);
                QCOMPARE(is.hits[at], was.hits[at]);
                QCOMPARE(is.line[at], was.line[at]);
                const bool filled = is.hits[at] == 0; // A measured height is another mean of the same hits.
                QVERIFY(std::isnan(was.height_m[at]) ||
                        std::abs(is.height_m[at] - was.height_m[at]) <= (filled ? 0.0f : 0.1f));
            }
    }

    void movesTheMapByTheCorrection() {
        const auto flown =
            made_up::fly({.ground_m = [](double, double) { return 1.0; }, .walk_share = 0.0, .lanes = 1});
        const PathCorrection correction{{{{Seconds(0.0), Vec3(2.0, -1.0, 0.5), Vec3::Zero()}}}};
        MapRebuild rebuild(flown.store, correction, HeightMap(0.25));
        while (rebuild.step()) {
        }
        const HeightMap map = rebuild.takeMap();
        QVERIFY(map.height_m(map.cellAt({-1.9, 1.0})));
        QVERIFY(!map.height_m(map.cellAt({39.9, 1.0})));
        QVERIFY(std::abs(*map.height_m(map.cellAt({10.0, 1.0})) - 0.5f) < 0.05f);
    }

    void givesACellTheDeviationOfItsNewestScan() {
        const auto flown = made_up::fly({.ground_m = [](double x_m, double) { return 0.5 * x_m; },
                                         .walk_share = 0.0,
                                         .noise_m = 0.0,
                                         .lanes = 1,
                                         .height_m = 25.0});
        const PathCorrection correction{{{{Seconds(0.0), Vec3::Zero(), Vec3(0.2, 0.7, 0.1)}}}};
        MapRebuild rebuild(flown.store, correction, HeightMap(0.25));
        while (rebuild.step()) {
        }
        const HeightMap map = rebuild.takeMap();
        const Raster heights = rasterOf(map);
        const Raster deviation = deviationOf(heights, map, flown.store, correction);
        QCOMPARE(deviation.heights_m.size(), heights.heights_m.size());
        const auto middle = static_cast<std::size_t>(heights.rows / 2 * heights.columns + heights.columns / 2);
        QVERIFY(std::abs(double(deviation.heights_m[middle]) - std::hypot(0.5 * 0.2, 0.1)) < 0.02);
        for (std::size_t cell = 0; cell < heights.heights_m.size(); ++cell)
            QCOMPARE(std::isnan(deviation.heights_m[cell]), std::isnan(heights.heights_m[cell]));
    }

    void invertsTheDiagonalOfASparseMatrix_data() {
        QTest::addColumn<int>("blocks");
        QTest::addColumn<int>("every");
        QTest::newRow("one block") << 1 << 1;
        QTest::newRow("a chain") << 12 << 1;
        QTest::newRow("a chain with ties across") << 30 << 7;
    }
    void invertsTheDiagonalOfASparseMatrix() {
        QFETCH(int, blocks);
        QFETCH(int, every);
        const Eigen::Index size = 4 * blocks;
        Eigen::MatrixXd full = 2.0 * Eigen::MatrixXd::Identity(size, size);
        std::srand(7);
        const auto tie = [&](int a, int b) {
            Eigen::VectorXd row = Eigen::VectorXd::Zero(size);
            row.segment<4>(4 * a) = Eigen::Vector4d::Random();
            row.segment<4>(4 * b) -= Eigen::Vector4d::Random();
            full += row * row.transpose();
        };
        for (int block = 0; block + 1 < blocks; ++block)
            tie(block, block + 1);
        for (int block = 0; block + every < blocks; block += every)
            tie(block, block + every);
        full.topLeftCorner<4, 4>() += Eigen::Matrix4d::Constant(0.1);
        const Eigen::MatrixXd inverse = full.inverse();
        const auto found = diagonalBlocksOfInverse(
            Eigen::SparseMatrix<double>(full.triangularView<Eigen::Lower>().toDenseMatrix().sparseView()));
        QCOMPARE(found.size(), std::size_t(blocks));
        for (int block = 0; block < blocks; ++block)
            QVERIFY((found[std::size_t(block)] - inverse.block<4, 4>(4 * block, 4 * block)).norm() < 1e-9);
    }

    void hasNoInverseOfWhatIsNotPositive() {
        Eigen::SparseMatrix<double> zero(4, 4);
        QVERIFY(diagonalBlocksOfInverse(zero).empty());
    }
};

USAR_TEST(tst_ScanStore)

} // namespace tst_scan_store

#include "tst_scan_store.moc"
