#include <QTest>

#include "core/campaign/statistics/more_pairs.h"
#include "tests/suite/suite.h"

namespace tst_more_pairs {

using namespace usar::campaign;

class tst_MorePairs : public QObject {
    Q_OBJECT
private slots:
    void theWidthShrinksWithTheRootOfThePairs_data() {
        QTest::addColumn<double>("estimate");
        QTest::addColumn<Interval>("interval");
        QTest::addColumn<int>("more"); // -1: nobody knows
        QTest::newRow("half the width is needed") << 2.0 << Interval{0.0, 4.0} << 60;
        QTest::newRow("the other direction") << -2.0 << Interval{-4.0, 0.0} << 60;
        QTest::newRow("to be equal") << 0.0 << Interval{-3.0, 3.0} << 160;
        QTest::newRow("beyond the margin already") << 3.0 << Interval{1.5, 4.5} << 0;
        QTest::newRow("within the margin already") << 0.1 << Interval{-0.9, 1.0} << 0;
        QTest::newRow("narrow enough, but askew") << 2.0 << Interval{0.9, 2.2} << 1;
        QTest::newRow("at the margin") << 1.0 << Interval{0.0, 2.0} << -1;
        QTest::newRow("nearly at the margin") << 1.001 << Interval{0.0, 2.0} << -1;
        QTest::newRow("no width is known") << 2.0 << Interval{} << -1;
    }
    void theWidthShrinksWithTheRootOfThePairs() {
        QFETCH(double, estimate);
        QFETCH(Interval, interval);
        QFETCH(int, more);
        const auto found = morePairsToDecide({20, estimate, interval}, 1.0);
        QCOMPARE(found ? static_cast<int>(*found) : -1, more);

        QVERIFY(!morePairsToDecide({0, 0.0, {-1.0, 1.0}}, 0.05)); // a rate without runs
    }
};

USAR_TEST(tst_MorePairs)

} // namespace tst_more_pairs

#include "tst_more_pairs.moc"
