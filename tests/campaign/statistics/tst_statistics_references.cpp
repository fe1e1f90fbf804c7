// What scipy says of the same samples; tests/data/campaign/make_references.py wrote it down.
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#include "core/campaign/statistics/bootstrap.h"
#include "core/campaign/statistics/holm.h"
#include "core/campaign/statistics/paired.h"
#include "core/campaign/statistics/proportion.h"
#include "core/campaign/statistics/sample.h"
#include "core/campaign/statistics/wilcoxon.h"
#include "tests/suite/suite.h"

namespace tst_statistics_references {

using namespace usar::campaign;

namespace {

/// The cases under a key; empty if the file is not there.
QJsonArray casesOf(const QString& key) {
    QFile file(QString(USAR_SOURCE_DIR) + "/tests/data/campaign/references.json");
    if (!file.open(QIODevice::ReadOnly))
        return {};
    return QJsonDocument::fromJson(file.readAll()).object()[key].toArray();
}

std::vector<double> numbersOf(const QJsonValue& value) {
    std::vector<double> numbers;
    for (const QJsonValue& number : value.toArray())
        numbers.push_back(number.toDouble());
    return numbers;
}

/// Adds one row for each case of a key, which is what a test function fetches as `given`.
template <class NameOf>
void addRows(const QString& key, NameOf name_of) {
    QTest::addColumn<QJsonObject>("given");
    for (const QJsonValue& one : casesOf(key))
        QTest::newRow(qPrintable(name_of(one.toObject()))) << one.toObject();
}

QString ownName(const QJsonObject& given) {
    return given["name"].toString();
}

/// Says how far two numbers are apart where it is more than they may be.
QByteArray apart(double actual, double expected, double tolerance) {
    return std::abs(actual - expected) <= tolerance
               ? QByteArray()
               : QByteArray::number(actual, 'g', 15) + " is not " + QByteArray::number(expected, 'g', 15);
}

QByteArray apart(const Interval& actual, const QJsonValue& expected, double tolerance) {
    return apart(actual.low, expected[0].toDouble(), tolerance) + apart(actual.high, expected[1].toDouble(), tolerance);
}

} // namespace

class tst_StatisticsReferences : public QObject {
    Q_OBJECT
private slots:
    void ratesHaveTheIntervalsOfScipy_data() {
        addRows("proportions", [](const QJsonObject& given) {
            return QString("%1 of %2").arg(given["successes"].toInt()).arg(given["trials"].toInt());
        });
    }
    void ratesHaveTheIntervalsOfScipy() {
        QFETCH(QJsonObject, given);
        const Count count{static_cast<std::size_t>(given["successes"].toInt()),
                          static_cast<std::size_t>(given["trials"].toInt())};
        const double confidence = given["confidence"].toDouble();
        QCOMPARE(apart(wilsonInterval(count, confidence), given["wilson"], 1e-9), QByteArray());
        QCOMPARE(apart(clopperPearsonInterval(count, confidence), given["clopper_pearson"], 1e-9), QByteArray());
        QCOMPARE(apart(highestRate(count, confidence), given["highest"].toDouble(), 1e-9), QByteArray());
        QCOMPARE(apart(lowestRate(count, confidence), given["lowest"].toDouble(), 1e-9), QByteArray());
    }

    void pairsThatDifferHaveTheBinomialTestOfScipy_data() {
        addRows("mcnemar", [](const QJsonObject& given) {
            return QString("%1 and %2").arg(given["baseline_only"].toInt()).arg(given["candidate_only"].toInt());
        });
    }
    void pairsThatDifferHaveTheBinomialTestOfScipy() {
        QFETCH(QJsonObject, given);
        PairedCount count;
        count.both = 17; // pairs that agree say nothing
        count.baseline_only = static_cast<std::size_t>(given["baseline_only"].toInt());
        count.candidate_only = static_cast<std::size_t>(given["candidate_only"].toInt());
        QCOMPARE(apart(mcNemar(count), given["p"].toDouble(), 1e-9), QByteArray());
    }

    void signedRanksHaveThePOfScipy_data() { addRows("wilcoxon", ownName); }
    void signedRanksHaveThePOfScipy() {
        QFETCH(QJsonObject, given);
        QCOMPARE(apart(wilcoxon(numbersOf(given["differences"])).p, given["p"].toDouble(), 1e-9), QByteArray());
    }

    void severalPAreAdjustedByHolm_data() {
        addRows("holm", [](const QJsonObject& given) { return QString("%1 values").arg(given["p"].toArray().size()); });
    }
    void severalPAreAdjustedByHolm() {
        QFETCH(QJsonObject, given);
        const std::vector<double> adjusted = holm(numbersOf(given["p"])), expected = numbersOf(given["adjusted"]);
        QCOMPARE(adjusted.size(), expected.size());
        for (std::size_t i = 0; i < expected.size(); ++i)
            QCOMPARE(apart(adjusted[i], expected[i], 1e-12), QByteArray());
    }

    void pairsHaveTheFiguresOfScipy_data() { addRows("pairs", ownName); }
    void pairsHaveTheFiguresOfScipy() {
        QFETCH(QJsonObject, given);
        const std::vector<double> baseline = numbersOf(given["baseline"]), candidate = numbersOf(given["candidate"]);
        const std::vector<double> change = differences(baseline, candidate);
        const auto check = [&](double actual, const char* key) { return apart(actual, given[key].toDouble(), 1e-9); };
        QCOMPARE(check(correlation(baseline, candidate), "correlation"), QByteArray());
        QCOMPARE(check(varianceRatio(baseline, candidate), "variance_ratio"), QByteArray());
        QCOMPARE(check(geometricMeanOfRatios(baseline, candidate), "geometric_mean"), QByteArray());
        QCOMPARE(check(median(change), "median"), QByteArray());
        QCOMPARE(check(trimmedMean(change, interquartile), "interquartile_mean"), QByteArray());
        QCOMPARE(check(quantileOfSorted(sortedCopy(change), 0.1), "tenth"), QByteArray());
    }

    /// Other draws give other ends: those of 100,000 resamples spread by 0.7 % of the width, measured over seeds.
    void resamplingHasTheBcaIntervalOfScipy_data() { addRows("bootstrap", ownName); }
    void resamplingHasTheBcaIntervalOfScipy() {
        QFETCH(QJsonObject, given);
        std::vector<double> values;
        std::vector<int> groups;
        int number = 0;
        for (const QJsonValue& group : given["groups"].toArray()) {
            for (const double value : numbersOf(group)) {
                values.push_back(value);
                groups.push_back(number);
            }
            ++number;
        }
        const Interval interval =
            bcaInterval(values, groups, given["trimmed_share"].toDouble(), {.resamples = 100'000, .seed = 5});
        const double width = given["high"].toDouble() - given["low"].toDouble();
        QCOMPARE(apart(interval.low, given["low"].toDouble(), 0.015 * width), QByteArray());
        QCOMPARE(apart(interval.high, given["high"].toDouble(), 0.015 * width), QByteArray());
    }
};

USAR_TEST(tst_StatisticsReferences)

} // namespace tst_statistics_references

#include "tst_statistics_references.moc"
