#include <cmath>
#include <limits>

#include <QTest>

#include "core/campaign/statistics/holm.h"
#include "core/campaign/statistics/paired.h"
#include "core/campaign/statistics/sample.h"
#include "core/campaign/statistics/wilcoxon.h"
#include "tests/suite/suite.h"

namespace tst_sample {

using namespace usar::campaign;

class tst_Sample : public QObject {
    Q_OBJECT
private slots:
    void nothingHasNoFigures() {
        const std::vector<double> none;
        QVERIFY(std::isnan(mean(none)));
        QVERIFY(std::isnan(median(none)));
        QVERIFY(std::isnan(trimmedMean(none, interquartile)));
        QVERIFY(std::isnan(variance(std::vector{1.0})));
        QVERIFY(std::isnan(correlation(none, none)));
        QVERIFY(std::isnan(probabilityOfImprovement(none, none, true)));
        QVERIFY(std::isnan(geometricMeanOfRatios(none, none)));
        QVERIFY(holm(none).empty());
        QCOMPARE(wilcoxon(none).p, 1.0);
    }

    void theMedianOfAnEvenNumberLiesBetweenTwo() {
        QCOMPARE(median(std::vector{4.0, 1.0, 3.0}), 3.0);
        QCOMPARE(median(std::vector{4.0, 1.0, 3.0, 100.0}), 3.5);
    }

    void theVarianceHasOneLessThanTheNumberOfValues() { QCOMPARE(variance(std::vector{1.0, 2.0, 6.0}), 7.0); }

    void theInterquartileMeanForgetsTheEnds() {
        QCOMPARE(trimmedMean(std::vector{-1000.0, 1.0, 2.0, 1000.0}, interquartile), 1.5);
        QCOMPARE(trimmedMean(std::vector{-1000.0, 1.0, 2.0}, interquartile), -997.0 / 3.0);
    }

    void aRunThatDidNotEndCountsTheLimit() {
        const double never = std::numeric_limits<double>::infinity();
        QCOMPARE(restrictedMean(std::vector{10.0, never, 80.0}, 60.0), (10.0 + 60.0 + 60.0) / 3.0);
    }

    void improvementLooksIntoTheGoodDirection() {
        const std::vector<double> before{5.0, 5.0, 5.0, 5.0}, after{1.0, 5.0, 9.0, 2.0};
        QCOMPARE(probabilityOfImprovement(before, after, true), 2.5 / 4.0);
        QCOMPARE(probabilityOfImprovement(before, after, false), 1.5 / 4.0);
    }

    void ratiosNeedPositiveValues() {
        QCOMPARE(geometricMeanOfRatios(std::vector{1.0, 100.0}, std::vector{4.0, 100.0}), 2.0);
        QVERIFY(std::isnan(geometricMeanOfRatios(std::vector{1.0, 0.0}, std::vector{4.0, 100.0})));
    }

    void pairingIsWorthWhatTheSeedExplains() {
        const std::vector<double> before{1.0, 2.0, 3.0, 4.0}, shifted{2.0, 3.0, 4.0, 5.0}, mirrored{4.0, 3.0, 2.0, 1.0};
        QCOMPARE(varianceRatio(before, shifted), 0.0);
        QCOMPARE(varianceRatio(before, mirrored), 2.0);
        QCOMPARE(correlation(before, mirrored), -1.0);
        QVERIFY(std::isnan(correlation(before, std::vector(4, 1.0))));
    }

    void ranksOfEqualSizesAreShared() {
        const SignedRank ranks = wilcoxon(std::vector{0.0, 1.0, -1.0, 2.0, -3.0});
        QCOMPARE(ranks.ranked, std::size_t{4});
        QCOMPARE(ranks.positive, 1.5 + 3.0);
        QCOMPARE(ranks.negative, 1.5 + 4.0);
    }

    void symmetricDifferencesAreNoEvidence() { QCOMPARE(wilcoxon(std::vector{-1.0, 1.0}).p, 1.0); }
};

USAR_TEST(tst_Sample)

} // namespace tst_sample

#include "tst_sample.moc"
