#include <QTest>

#include "core/base/random.h"
#include "core/campaign/statistics/proportion.h"
#include "tests/suite/suite.h"

namespace tst_proportion {

using namespace usar;
using namespace usar::campaign;

namespace {

constexpr int draws = 1000;

/// How many of 1,000 samples have an interval that holds the rate that made them.
template <class IntervalOf>
int covered(double rate, std::size_t trials, IntervalOf interval_of) {
    Random random = seeded(7, trials);
    int held = 0;
    for (int draw = 0; draw < draws; ++draw) {
        Count count{0, trials};
        for (std::size_t i = 0; i < trials; ++i)
            count.successes += uniform(random, 0.0, 1.0) < rate ? 1 : 0;
        const Interval interval = interval_of(count);
        held += interval.low <= rate && rate <= interval.high ? 1 : 0;
    }
    return held;
}

} // namespace

class tst_Proportion : public QObject {
    Q_OBJECT
private slots:
    void noCrashInManyRunsProvesOnlySoMuch() {
        QVERIFY(std::abs(highestRate({0, 200}) - 0.0149) < 5e-5);
        QVERIFY(std::abs(highestRate({0, 1000}) - 0.0030) < 5e-5);
        QVERIFY(std::abs(highestRate({0, 10'000}) - 0.0003) < 5e-6);
    }

    void withoutTrialsAnyRateIsPossible() {
        QCOMPARE(wilsonInterval({0, 0}), (Interval{0.0, 1.0}));
        QCOMPARE(clopperPearsonInterval({0, 0}), (Interval{0.0, 1.0}));
        QCOMPARE(rateDifference({}), (Interval{-1.0, 1.0}));
        QCOMPARE(Count{}.rate(), 0.0);
        QCOMPARE(mcNemar({}), 1.0);
    }

    void intervalsHoldTheRateAsOftenAsTheySay_data() {
        QTest::addColumn<double>("rate");
        QTest::addColumn<std::size_t>("trials");
        QTest::newRow("half of 40") << 0.5 << std::size_t{40};
        QTest::newRow("most of 50") << 0.9 << std::size_t{50};
        QTest::newRow("few of 200") << 0.03 << std::size_t{200};
    }
    /// 950 of 1,000 are expected with a deviation of 7; Wilson's interval itself is off by up to 1.5 % with few trials.
    void intervalsHoldTheRateAsOftenAsTheySay() {
        QFETCH(double, rate);
        QFETCH(std::size_t, trials);
        const int wilson = covered(rate, trials, [](const Count& c) { return wilsonInterval(c, 0.95); });
        QVERIFY2(wilson >= 920 && wilson <= 975, qPrintable(QString::number(wilson)));
        const int exact = covered(rate, trials, [](const Count& c) { return clopperPearsonInterval(c, 0.95); });
        QVERIFY2(exact >= 945, qPrintable(QString::number(exact)));
        const int upper = covered(rate, trials, [](const Count& c) { return Interval{0.0, highestRate(c, 0.9)}; });
        QVERIFY2(upper >= 890 && upper <= 965, qPrintable(QString::number(upper)));
    }

    void theDifferenceOfRatesIsHeldAsOftenAsItSays() {
        Random random = seeded(8, 0);
        int held = 0;
        for (int draw = 0; draw < draws; ++draw) {
            PairedCount count;
            for (int i = 0; i < 60; ++i) { // The candidate loses 5 % and gains 15 %.
                const double chance = uniform(random, 0.0, 1.0);
                ++(chance < 0.05   ? count.baseline_only
                   : chance < 0.20 ? count.candidate_only
                   : chance < 0.85 ? count.both
                                   : count.neither);
            }
            const Interval interval = rateDifference(count);
            held += interval.low <= 0.1 && 0.1 <= interval.high ? 1 : 0;
        }
        QVERIFY2(held >= 930 && held <= 975, qPrintable(QString::number(held)));
    }

    /// By hand: 12 pairs that gained and 3 that lost of 100, one added to each, of 102.
    void theDifferenceOfRatesIsThatOfBonettAndPrice() {
        const Interval interval = rateDifference({70, 3, 12, 15});
        QVERIFY(std::abs(interval.low - 0.010881) < 1e-5);
        QVERIFY(std::abs(interval.high - 0.165590) < 1e-5);
    }

    void ratesOfPairsAreThoseOfTheirSides() {
        const PairedCount count{70, 3, 12, 15};
        QCOMPARE(count.baseline(), (Count{73, 100}));
        QCOMPARE(count.candidate(), (Count{82, 100}));
    }
};

USAR_TEST(tst_Proportion)

} // namespace tst_proportion

#include "tst_proportion.moc"
