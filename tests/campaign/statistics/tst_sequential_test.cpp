#include <cmath>

#include <QTest>

#include "core/base/random.h"
#include "core/campaign/statistics/sequential_test.h"
#include "tests/suite/suite.h"

namespace tst_sequential_test {

using namespace usar;
using namespace usar::campaign;

namespace {

struct Verdicts {
    int better = 0;
    int worse = 0;
    std::size_t pairs_to_better = 0; ///< sum over the campaigns with this verdict
};

/// 1,000 campaigns of at most `most_pairs`, each looked at after every pair and ended by the first verdict.
Verdicts campaignsWith(double chance_of_gain, double chance_of_tie, std::size_t most_pairs) {
    Random random = seeded(11, 0);
    Verdicts verdicts;
    for (int campaign = 0; campaign < 1000; ++campaign) {
        SequentialTest test(0.5);
        while (test.verdict() == SequentialVerdict::Undecided && test.pairs() < most_pairs) {
            const bool is_tie = uniform(random, 0.0, 1.0) < chance_of_tie;
            const bool is_gain = uniform(random, 0.0, 1.0) < chance_of_gain;
            test.add((is_gain ? 1.0 : -1.0) * (is_tie ? 0.4 : 2.0));
        }
        verdicts.worse += test.verdict() == SequentialVerdict::Worse ? 1 : 0;
        if (test.verdict() == SequentialVerdict::Better) {
            ++verdicts.better;
            verdicts.pairs_to_better += test.pairs();
        }
    }
    return verdicts;
}

} // namespace

class tst_SequentialTest : public QObject {
    Q_OBJECT
private slots:
    void equalVariantsRarelyGetAVerdictThoughEachPairIsLookedAt_data() {
        QTest::addColumn<double>("chance_of_tie");
        QTest::newRow("no ties") << 0.0;
        QTest::newRow("many ties") << 0.7;
    }
    /// A p-value of 5 % that is looked at as often gives a false verdict in a third of the campaigns.
    void equalVariantsRarelyGetAVerdictThoughEachPairIsLookedAt() {
        QFETCH(double, chance_of_tie);
        const Verdicts verdicts = campaignsWith(0.5, chance_of_tie, 500);
        const QByteArray found = QByteArray::number(verdicts.better + verdicts.worse) + " of 1000";
        QVERIFY2(verdicts.better + verdicts.worse <= 50, found);
        QVERIFY2(verdicts.better + verdicts.worse >= 5, found); // or the test would be blind
    }

    void aClearGainIsFoundSoon() {
        const Verdicts verdicts = campaignsWith(0.8, 0.0, 200);
        QVERIFY(verdicts.better >= 990);
        QVERIFY(verdicts.worse <= 1);
        QVERIFY(verdicts.pairs_to_better / static_cast<std::size_t>(verdicts.better) <= 40);
    }

    void aSmallGainIsFoundInTheEnd() {
        const Verdicts verdicts = campaignsWith(0.6, 0.0, 1000);
        QVERIFY2(verdicts.better >= 980, QByteArray::number(verdicts.better));
    }

    void aLossIsFoundAsWellAsAGain() {
        const Verdicts verdicts = campaignsWith(0.2, 0.0, 200);
        QVERIFY(verdicts.worse >= 990);
    }

    void noVerdictComesBeforeTwentyPairs() {
        SequentialTest test(0.0);
        for (std::size_t i = 1; i < SequentialTest::least_pairs; ++i) {
            test.add(1.0);
            QCOMPARE(test.verdict(), SequentialVerdict::Undecided);
        }
        test.add(1.0);
        QCOMPARE(test.verdict(), SequentialVerdict::Better);
    }

    void aVerdictStays() {
        SequentialTest test(0.0);
        for (int i = 0; i < 20; ++i)
            test.add(-1.0);
        QCOMPARE(test.verdict(), SequentialVerdict::Worse);
        for (int i = 0; i < 200; ++i)
            test.add(1.0);
        QCOMPARE(test.verdict(), SequentialVerdict::Worse);
    }

    void withinTheMarginNothingIsWonOrLost() {
        SequentialTest test(0.5);
        test.add(0.5);
        test.add(-0.5);
        test.add(0.51);
        QCOMPARE(test.pairs(), std::size_t{3});
        QCOMPARE(test.wins(), std::size_t{1});
        QCOMPARE(test.losses(), std::size_t{0});
    }

    /// By hand: the mean of 2q over q from 1/2 to 1 is 3/2, of 4q(1-q) it is 2/3.
    void theWealthIsTheMeanOverAllStakes() {
        SequentialTest test(0.0);
        QVERIFY(std::abs(test.evidenceForBetter()) < 1e-12);
        test.add(1.0);
        QVERIFY(std::abs(std::exp(test.evidenceForBetter()) - 1.5) < 1e-12);
        QVERIFY(std::abs(std::exp(test.evidenceForWorse()) - 0.5) < 1e-12);
        test.add(-1.0);
        QVERIFY(std::abs(std::exp(test.evidenceForBetter()) - 2.0 / 3.0) < 1e-12);
    }

    void tensOfThousandsOfPairsKeepAFiniteWealth() {
        SequentialTest test(0.0);
        for (int i = 0; i < 40'000; ++i)
            test.add(i % 2 == 0 ? 1.0 : -1.0);
        QVERIFY(std::isfinite(test.evidenceForBetter()));
        QVERIFY(std::abs(test.evidenceForBetter() - test.evidenceForWorse()) < 1e-6);
        QVERIFY(test.evidenceForBetter() < 0.0);
    }
};

USAR_TEST(tst_SequentialTest)

} // namespace tst_sequential_test

#include "tst_sequential_test.moc"
