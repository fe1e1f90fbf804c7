#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <QTest>

#include "core/campaign/statistics/more_pairs.h"
#include "tests/suite/suite.h"

namespace tst_more_pairs {

using namespace usar::campaign;

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

} // namespace

class tst_MorePairs : public QObject {
    Q_OBJECT
private slots:
    void theWidthShrinksWithTheRootOfThePairs_data() {
        QTest::addColumn<double>("estimate");
        QTest::addColumn<Interval>("interval");
        QTest::addColumn<int>("more"); // -1: nobody knows
        QTest::newRow("half the width is needed") << 2.0 << Interval{0.0, 4.0} << 60;
        QTest::newRow("the other direction") << -2.0 << Interval{-4.0, 0.0} << 60;
        QTest::newRow("to be equal") << 0.0 << Interval{-3.0, 3.0} << 306; // 20 (3 + 3 0.6745 / 1.960)^2 = 325.1
        QTest::newRow("beyond the margin already") << 3.0 << Interval{1.5, 4.5} << 0;
        QTest::newRow("within the margin already") << 0.1 << Interval{-0.9, 1.0} << 0;
        QTest::newRow("narrow enough, but askew") << 2.0 << Interval{0.9, 2.2} << 5;
        QTest::newRow("only the side that blocks counts") << 2.0 << Interval{0.5, 9.0} << 25;
        QTest::newRow("askew in the other direction") << -2.0 << Interval{-9.0, -0.5} << 25;
        // The error is 1.5 / 3.92, so 0.322 of the 0.5 are expected to stay, and 20 (1 / 0.678)^2 = 43.5.
        QTest::newRow("to be equal, askew") << 0.5 << Interval{0.0, 1.5} << 24;
        QTest::newRow("to be equal, too low alone") << -0.5 << Interval{-1.5, 0.0} << 24;
        QTest::newRow("at the margin, hardly wider than it") << 1.0 << Interval{0.99, 1.01} << -1;
        QTest::newRow("just beyond the margin") << 1.001 << Interval{0.0, 2.0} << -1;
        QTest::newRow("no width is known") << 2.0 << Interval{} << -1;
        QTest::newRow("no width is known within the margin") << 0.5 << Interval{nan, nan} << -1;
    }
    void theWidthShrinksWithTheRootOfThePairs() {
        QFETCH(double, estimate);
        QFETCH(Interval, interval);
        QFETCH(int, more);
        const auto found = morePairsToDecide({20, estimate, interval}, 1.0);
        QCOMPARE(found ? static_cast<int>(*found) : -1, more);

        QVERIFY(!morePairsToDecide({0, 0.0, {-1.0, 1.0}}, 0.05)); // a rate without runs
    }

    void ratesAreJudgedByTheIntervalsOfMorePairs_data() {
        QTest::addColumn<QList<int>>("kinds"); // both, the baseline only, the candidate only, neither
        QTest::addColumn<int>("more");
        QTest::newRow("none differs") << QList<int>{20, 0, 0, 0} << 34; // 1.96 sqrt(2) / (n + 2) is 0.05 at 53.4
        QTest::newRow("enough") << QList<int>{60, 0, 0, 0} << 0;
        // A difference of 0.05 with an error of 0.0487: 0.011 is expected, and the interval reaches 0.037 at 173 pairs,
        // so its end is expected at the margin.
        QTest::newRow("one differs") << QList<int>{19, 1, 0, 0} << 153;
        QTest::newRow("at the margin") << QList<int>{38000, 2000, 0, 0} << -1;
        QTest::newRow("no pairs") << QList<int>{0, 0, 0, 0} << -1;
    }
    void ratesAreJudgedByTheIntervalsOfMorePairs() {
        QFETCH(QList<int>, kinds);
        const auto part = [&](int i) { return static_cast<std::size_t>(kinds[i]); };
        const PairedCount count{part(0), part(1), part(2), part(3)};
        const auto found = morePairsToDecide(count, 0.05, 0.95, 0.05);
        QTEST(found ? static_cast<int>(*found) : -1, "more");
        const PairedCount worse{10, 5, 0, 5}; // A quarter of the pairs.
        const std::size_t total = 20 + morePairsToDecide(worse, 0.05, 0.95, 0.01).value();
        QVERIFY2(total > 25 && total < 40, QByteArray::number(qulonglong(total)));
        QVERIFY(morePairsToDecide(worse, 0.05, 0.95, 1e-6).value() > total); // The test must agree.
    }

    /// The difference is normal with a mean of 0 and a deviation of 1, so with n pairs the interval of 95 % lies within
    /// the margin with a chance of one half if 1.960 + 0.6745 = margin sqrt(n).
    void equalVariantsAreToldWhatMakesThemEqual_data() {
        QTest::addColumn<double>("needed");
        QTest::newRow("twice the pairs") << 100.0;
        QTest::newRow("four times the pairs") << 200.0;
        QTest::newRow("eight times the pairs") << 400.0;
    }
    void equalVariantsAreToldWhatMakesThemEqual() {
        QFETCH(double, needed);
        constexpr std::size_t pairs = 50, campaigns = 2001;
        const double margin = (1.960 + 0.6745) / std::sqrt(needed), error = 1.0 / std::sqrt(double(pairs));
        std::mt19937_64 generator(7);
        std::normal_distribution<double> measured(0.0, error);
        std::vector<double> foretold;
        std::size_t equal = 0;
        while (foretold.size() < campaigns) {
            const double estimate = measured(generator);
            const Interval interval{estimate - 1.960 * error, estimate + 1.960 * error};
            const auto more = morePairsToDecide({pairs, estimate, interval}, margin);
            if (more == std::size_t(0))
                continue; // It is decided already.
            const double total = more ? double(pairs + *more) : 1e6;
            foretold.push_back(total);
            // The campaign goes on to the number that it was told.
            const double rest = total - pairs;
            const double mean =
                (pairs * estimate + rest * std::normal_distribution<double>(0.0, 1.0 / std::sqrt(rest))(generator)) /
                total;
            equal += std::abs(mean) + 1.960 / std::sqrt(total) <= margin;
        }
        std::ranges::nth_element(foretold, foretold.begin() + campaigns / 2);
        const double middle = foretold[campaigns / 2];
        // Two of three estimates are within their error of zero, for which the number is the one above; rounded up.
        QVERIFY2(middle >= 0.99 * needed && middle <= 1.1 * needed, QByteArray::number(middle));
        const double share = double(equal) / double(campaigns);
        QVERIFY2(share > 0.4 && share < 0.7, QByteArray::number(share));
    }

    /// The deviates of p are 1.645 for 0.1, 1.960 for 0.05 and 2.576 for 0.01.
    void theTestMustAgreeToo_data() {
        QTest::addColumn<double>("estimate");
        QTest::addColumn<Interval>("interval");
        QTest::addColumn<double>("p");
        QTest::addColumn<int>("more");
        const Interval beyond{1.2, 4.8};
        QTest::newRow("it does") << 3.0 << beyond << 0.009 << 0;
        QTest::newRow("not yet") << 3.0 << beyond << 0.05 << 73;    // 100 (2.576 / 1.960)^2 = 172.7
        QTest::newRow("not nearly") << 3.0 << beyond << 0.1 << 146; // 100 (2.576 / 1.645)^2 = 245.2
        QTest::newRow("it sees nothing") << 3.0 << beyond << 1.0 << -1;
        QTest::newRow("the interval needs more") << 3.0 << Interval{-1.0, 7.0} << 0.05 << 300;
        QTest::newRow("equality asks for no test") << 0.0 << Interval{-1.5, 1.5} << 1.0 << 307; // 100 (2.016)^2 = 406.5
        QTest::newRow("equal already") << 0.0 << Interval{-0.5, 0.5} << 1.0 << 0;
    }
    void theTestMustAgreeToo() {
        QFETCH(double, estimate);
        QFETCH(Interval, interval);
        QFETCH(double, p);
        const auto found = morePairsToDecide({100, estimate, interval, p, 0.01}, 1.0);
        QTEST(found ? static_cast<int>(*found) : -1, "more");
    }
};

USAR_TEST(tst_MorePairs)

} // namespace tst_more_pairs

#include "tst_more_pairs.moc"
