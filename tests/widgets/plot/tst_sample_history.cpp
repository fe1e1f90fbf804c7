#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <QTest>

#include "tests/suite/suite.h"
#include "widgets/models/plot/sample_history.h"

namespace tst_sample_history {

using namespace usar::widgets;

namespace {

const double nan = std::numeric_limits<double>::quiet_NaN();

/// What a history is compared with: all samples, in a list.
struct Everything {
    std::vector<Sample> samples;

    Statistics between(double from_s, double to_s) const {
        Statistics all;
        double sum = 0.0;
        std::vector<double> values;
        for (const Sample& sample : samples)
            if (sample.time_s >= from_s && sample.time_s <= to_s && !std::isnan(sample.value))
                values.push_back(sample.value);
        all.count = values.size();
        if (values.empty())
            return all;
        for (const double value : values)
            sum += value;
        all.least = *std::ranges::min_element(values);
        all.most = *std::ranges::max_element(values);
        all.mean = sum / static_cast<double>(values.size());
        double squares = 0.0;
        for (const double value : values)
            squares += (value - all.mean) * (value - all.mean);
        all.deviation = values.size() > 1 ? std::sqrt(squares / static_cast<double>(values.size() - 1)) : 0.0;
        return all;
    }
};

/// A walk with spikes, gaps and uneven times, the same for each seed.
Everything walk(unsigned seed, int count) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> step(-1.0, 1.0);
    Everything all;
    double time_s = 100.0;
    double value = 0.0;
    for (int i = 0; i < count; ++i) {
        time_s += random() % 10 == 0 ? 0.0 : 0.05 * (1.0 + step(random));
        value += step(random);
        const double spike = random() % 997 == 0 ? 1000.0 * step(random) : 0.0;
        all.samples.push_back({time_s, random() % 50 == 0 ? nan : value + spike});
    }
    return all;
}

SampleHistory historyOf(const Everything& all, std::size_t exact, std::size_t digests) {
    SampleHistory history(exact, digests);
    for (const Sample& sample : all.samples)
        history.append(sample);
    return history;
}

bool near(double a, double b) {
    return std::abs(a - b) <= 1e-9 * std::max({1.0, std::abs(a), std::abs(b)});
}

bool same(const Sample& a, const Sample& b) {
    return a.time_s == b.time_s && (a.value == b.value || (std::isnan(a.value) && std::isnan(b.value)));
}

} // namespace

class tst_SampleHistory : public QObject {
    Q_OBJECT
private slots:
    void fewSamplesAreDrawnOneByOne();
    void theLineReachesBeyondBothEdges();
    void noPeakIsLost_data() { lengths(); }
    void noPeakIsLost();
    void everyColumnHasItsExtremes();
    void theLineHasFewPoints_data() { lengths(); }
    void theLineHasFewPoints();
    void theNewestMinutesAreExact();
    void everyPointIsASampleThatCame_data() { lengths(); }
    void everyPointIsASampleThatCame();
    void statisticsAgreeWithTheList_data() { lengths(); }
    void statisticsAgreeWithTheList();
    void statisticsOfOldPartsSayThatTheyAreNotExact();
    void aValueIsTheNewestUntilThen();
    void anOldValueSaysThatItIsNotExact();
    void memoryStaysBounded();
    void gapsStay();
    void nothingIsThereAfterClear();

private:
    static void lengths();
};

void tst_SampleHistory::lengths() {
    QTest::addColumn<int>("count");
    for (const int count : {1, 2, 63, 64, 65, 500, 1'000, 1'100, 5'000, 40'000})
        QTest::addRow("%d samples", count) << count;
}

void tst_SampleHistory::fewSamplesAreDrawnOneByOne() {
    const Everything all = walk(1, 300);
    const auto line = historyOf(all, 1000, 16).curve(0.0, 1e9, 400);
    QVERIFY(std::ranges::equal(line, all.samples, same));
}

void tst_SampleHistory::theLineReachesBeyondBothEdges() {
    SampleHistory history;
    for (int i = 0; i < 10; ++i)
        history.append({i * 1.0, i * 10.0});
    const auto line = history.curve(3.5, 5.5, 100);
    QCOMPARE(line.size(), 4U);
    QCOMPARE(line.front().time_s, 3.0);
    QCOMPARE(line.back().time_s, 6.0);
}

void tst_SampleHistory::noPeakIsLost() {
    QFETCH(int, count);
    for (unsigned seed = 1; seed <= 5; ++seed) {
        const Everything all = walk(seed, count);
        const Statistics truth = all.between(0.0, 1e9);
        const SampleHistory history = historyOf(all, 1000, 16);
        for (const int columns : {1, 10, 300}) {
            double least = std::numeric_limits<double>::infinity();
            double most = -least;
            for (const Sample& sample : history.curve(all.samples.front().time_s, all.samples.back().time_s, columns))
                if (!std::isnan(sample.value)) {
                    least = std::min(least, sample.value);
                    most = std::max(most, sample.value);
                }
            if (truth.count > 0) {
                QCOMPARE(least, truth.least);
                QCOMPARE(most, truth.most);
            }
        }
    }
}

void tst_SampleHistory::everyColumnHasItsExtremes() {
    const Everything all = walk(7, 20'000);
    const SampleHistory history = historyOf(all, 30'000, 16); // all of it is exact
    const double from_s = 200.0;
    const int columns = 137;
    const double width_s = 2.0;
    const auto line = history.curve(from_s, from_s + columns * width_s, columns);
    for (int column = 0; column < columns; ++column) {
        Everything here;
        Everything drawn;
        const auto inside = [&](const Sample& sample) {
            return std::floor((sample.time_s - from_s) / width_s) == column;
        };
        std::ranges::copy_if(all.samples, std::back_inserter(here.samples), inside);
        std::ranges::copy_if(line, std::back_inserter(drawn.samples), inside);
        const Statistics truth = here.between(0.0, 1e9);
        const Statistics seen = drawn.between(0.0, 1e9);
        QCOMPARE(seen.least, truth.least);
        QCOMPARE(seen.most, truth.most);
        if (here.samples.empty())
            continue;
        QVERIFY(same(drawn.samples.front(), here.samples.front()));
        QVERIFY(same(drawn.samples.back(), here.samples.back()));
    }
}

void tst_SampleHistory::theLineHasFewPoints() {
    QFETCH(int, count);
    const Everything all = walk(3, count);
    const SampleHistory history = historyOf(all, 1000, 16);
    for (const int columns : {1, 20, 100})
        // At most four points for each column and each digest that is wider than one, and one beyond each edge.
        QVERIFY(history.curve(all.samples.front().time_s, all.samples.back().time_s, columns).size() <=
                static_cast<std::size_t>(4 * (columns + 1 + 17) + 2));
}

void tst_SampleHistory::theNewestMinutesAreExact() {
    const Everything all = walk(5, 10'000);
    const SampleHistory history = historyOf(all, 1000, 16);
    const auto exact = std::ranges::lower_bound(all.samples, history.exactFrom_s(), {}, &Sample::time_s);
    QVERIFY(all.samples.end() - exact >= 1000);
    const auto line = history.curve(history.exactFrom_s() + 1.0, all.samples.back().time_s, 5000);
    const std::vector<Sample> newest(all.samples.end() - static_cast<std::ptrdiff_t>(line.size()), all.samples.end());
    QVERIFY(line.size() > 900);
    QVERIFY(std::ranges::equal(line, newest, same));
}

void tst_SampleHistory::everyPointIsASampleThatCame() {
    QFETCH(int, count);
    const Everything all = walk(9, count);
    const SampleHistory history = historyOf(all, 1000, 16);
    const auto came = [&](const Sample& sample) {
        const auto [first, last] = std::ranges::equal_range(all.samples, sample.time_s, {}, &Sample::time_s);
        return std::any_of(first, last, [&](const Sample& each) { return same(each, sample); });
    };
    const auto line = history.curve(110.0, 900.0, 200);
    QVERIFY(std::ranges::all_of(line, came));
    QVERIFY(std::ranges::is_sorted(line, {}, &Sample::time_s));
    const auto known = history.knownSamples();
    QVERIFY(std::ranges::all_of(known, came));
    QVERIFY(std::ranges::is_sorted(known, {}, &Sample::time_s));
}

void tst_SampleHistory::statisticsAgreeWithTheList() {
    QFETCH(int, count);
    for (unsigned seed = 1; seed <= 5; ++seed) {
        const Everything all = walk(seed, count);
        const SampleHistory history = historyOf(all, 1000, 16);
        const double end_s = all.samples.back().time_s;
        // The whole, and spans that begin in the exact part.
        for (const double from_s : {0.0, history.exactFrom_s() + 0.1, 0.5 * (history.exactFrom_s() + end_s)})
            for (const double to_s : {end_s, end_s - 1.3}) {
                if (from_s == 0.0 && to_s != end_s && history.exactFrom_s() > history.oldest_s() &&
                    to_s <= history.exactFrom_s())
                    continue;
                const Statistics truth = all.between(from_s, to_s);
                const Statistics told = history.statistics(from_s, to_s);
                QVERIFY(told.exact);
                QCOMPARE(told.count, truth.count);
                if (truth.count == 0)
                    continue;
                QCOMPARE(told.least, truth.least);
                QCOMPARE(told.most, truth.most);
                QVERIFY2(near(told.mean, truth.mean), qPrintable(QString::number(told.mean - truth.mean)));
                QVERIFY(near(told.deviation, truth.deviation));
            }
    }
}

void tst_SampleHistory::statisticsOfOldPartsSayThatTheyAreNotExact() {
    const Everything all = walk(2, 40'000);
    const SampleHistory history = historyOf(all, 1000, 16);
    const double from_s = all.samples[10'123].time_s;
    const double to_s = all.samples[20'321].time_s;
    const Statistics told = history.statistics(from_s, to_s);
    QVERIFY(!told.exact);
    const Statistics truth = all.between(from_s, to_s);
    QVERIFY(told.least <= truth.least && told.most >= truth.most); // no peak of the span is missing
    QVERIFY(told.count >= truth.count);
}

void tst_SampleHistory::aValueIsTheNewestUntilThen() {
    SampleHistory history;
    QVERIFY(!history.at(1.0));
    for (const Sample& sample : {Sample{1.0, 0.1}, {2.0, nan}, {3.0, 3.0}})
        history.append(sample);
    QVERIFY(!history.at(0.9));
    QVERIFY(history.at(1.0) == std::optional(Reading{0.1, true}));
    QVERIFY(history.at(1.9) == std::optional(Reading{0.1, true}));
    QVERIFY(!history.at(2.5));
    QVERIFY(history.at(1e9) == std::optional(Reading{3.0, true}));
}

void tst_SampleHistory::anOldValueSaysThatItIsNotExact() {
    SampleHistory history(64, 4);
    for (int i = 0; i < 10'000; ++i)
        history.append({i * 1.0, i * 1.0});
    const std::optional<Reading> old = history.at(1'234.5);
    QVERIFY(old && !old->exact);
    QVERIFY(history.at(9'990.5) == std::optional(Reading{9'990.0, true}));
    QVERIFY(history.at(0.0) == std::optional(Reading{0.0, true}));
}

void tst_SampleHistory::memoryStaysBounded() {
    SampleHistory history(1000, 16);
    const std::size_t bound = (1000 + 64) * sizeof(Sample) + ((1000 + 64) / 64 + 1 + 16 + 1) * sizeof(Digest);
    for (int i = 0; i < 200'000; ++i) {
        history.append({i * 0.1, std::sin(i * 0.01)});
        if (i % 1000 == 0)
            QVERIFY(history.memory_bytes() <= bound);
    }
    QCOMPARE(history.size(), 200'000U);
    QCOMPARE(history.oldest_s(), 0.0);
}

void tst_SampleHistory::gapsStay() {
    SampleHistory history(64, 64);
    for (int i = 0; i < 10'000; ++i)
        history.append({i * 1.0, i >= 4'000 && i < 6'000 ? nan : 1.0});
    const auto line = history.curve(0.0, 10'000.0, 50);
    const auto in_gap = [](const Sample& sample) { return sample.time_s > 4'100.0 && sample.time_s < 5'900.0; };
    QVERIFY(std::ranges::any_of(line, in_gap));
    for (const Sample& sample : line)
        QVERIFY(!in_gap(sample) || std::isnan(sample.value));
}

void tst_SampleHistory::nothingIsThereAfterClear() {
    SampleHistory history(64, 4);
    for (int i = 0; i < 1'000; ++i)
        history.append({i * 1.0, 1.0});
    history.clear();
    QVERIFY(history.empty());
    QVERIFY(history.curve(0.0, 1e6, 100).empty());
    QVERIFY(history.knownSamples().empty());
    QCOMPARE(history.statistics(0.0, 1e6).count, 0U);
    history.append({1.0, 2.0});
    QCOMPARE(history.size(), 1U);
}

USAR_TEST(tst_SampleHistory)

} // namespace tst_sample_history

#include "tst_sample_history.moc"
