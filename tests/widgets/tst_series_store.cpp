#include <cmath>
#include <limits>

#include <QTest>

#include "core/protocol/reader.h"
#include "tests/suite/suite.h"
#include "widgets/models/series_store.h"

namespace tst_series_store {

using namespace usar;
using namespace usar::widgets;

namespace {

const std::string f1 = "SEN Sonar/F1/range";

protocol::InfoLine sonar(double time_s, const std::string& range) {
    protocol::Reader reader;
    return reader.read("SEN {Time " + std::to_string(time_s) + "} {Type Sonar} {Name F1 Range " + range +
                       "} {Name F2 Range 1.5}");
}

protocol::InfoLine timeless() {
    protocol::Reader reader;
    return reader.read("SEN {Type Sonar} {Name F1 Range 3.0}");
}

} // namespace

class tst_SeriesStore : public QObject {
    Q_OBJECT
private slots:
    void valueAtIsTheNewestUntilThen();
    void recordsOnlyWhatIsWatched();
    void learnsTheUnit();
    void watchesAPathOnce();
    void messagesWithoutTimeAreStampedWithNow();
    void notANumberIsAGap();
    void flagsAreZeroAndOne();
    void textsAreLeftOut();
    void timeThatIsNoNumberIsLeftOut_data();
    void timeThatIsNoNumberIsLeftOut();
    void lateValuesAreLeftOut();
    void aClockThatBeginsAgainStartsNewHistories();
    void oldestFallOffTheRing();
    void removedAndAddedAgainIsAnotherHistory();
    void csvMergesTheTimes();
    void csvQuotesCommas();
    void csvOfNothingIsAHeader();
};

void tst_SeriesStore::recordsOnlyWhatIsWatched() {
    SeriesStore store;
    QVERIFY(!store.take(sonar(1.0, "2.0"), Seconds(0)));
    store.add(f1);
    QVERIFY(store.take(sonar(2.0, "2.5"), Seconds(0)));
    QCOMPARE(store.series().size(), 1U);
    QCOMPARE(store.series()[0].samples.size(), 1U);
    QVERIFY(store.series()[0].samples[0] == (Sample{2.0, 2.5}));
    store.add("SEN Sonar/F9/range");
    QVERIFY(store.take(sonar(3.0, "2.5"), Seconds(0)));
    QVERIFY(store.series()[1].samples.empty());
}

void tst_SeriesStore::learnsTheUnit() {
    SeriesStore store;
    store.add(f1);
    store.take(sonar(1.0, "2.0"), Seconds(0));
    QCOMPARE(store.series()[0].unit, std::string("m"));
}

void tst_SeriesStore::watchesAPathOnce() {
    SeriesStore store;
    QVERIFY(store.add(f1));
    QVERIFY(!store.add(f1));
    QVERIFY(!store.add(""));
    QVERIFY(store.remove(f1));
    QVERIFY(!store.remove(f1));
}

void tst_SeriesStore::messagesWithoutTimeAreStampedWithNow() {
    SeriesStore store;
    store.add(f1);
    store.take(timeless(), Seconds(7.5));
    QCOMPARE(store.series()[0].samples[0].time_s, 7.5);
}

void tst_SeriesStore::notANumberIsAGap() {
    SeriesStore store;
    store.add(f1);
    store.take(sonar(1.0, "nan"), Seconds(0));
    QCOMPARE(store.series()[0].samples.size(), 1U);
    QVERIFY(std::isnan(store.series()[0].samples[0].value));
}

void tst_SeriesStore::flagsAreZeroAndOne() {
    SeriesStore store;
    store.add("NFO//lockstep");
    store.add("NFO/lockstep");
    protocol::Reader reader;
    store.take(reader.read("NFO {Lockstep True}"), Seconds(1));
    store.take(reader.read("NFO {Lockstep False}"), Seconds(2));
    std::vector<double> values;
    for (const Series& series : store.series())
        for (const Sample& sample : series.samples)
            values.push_back(sample.value);
    QCOMPARE(values, (std::vector<double>{1.0, 0.0}));
}

void tst_SeriesStore::textsAreLeftOut() {
    protocol::Reader reader;
    const protocol::InfoLine line = reader.read("SEN {Time 1} {Type GPS} {Name G} {Latitude 39,8.03,N}");
    SeriesStore store;
    store.add("SEN GPS/G/Latitude");
    store.take(line, Seconds(0));
    QVERIFY(store.series()[0].samples.empty());
}

void tst_SeriesStore::timeThatIsNoNumberIsLeftOut_data() {
    QTest::addColumn<double>("now_s");
    QTest::newRow("not a number") << std::nan("");
    QTest::newRow("infinite") << std::numeric_limits<double>::infinity();
}

void tst_SeriesStore::timeThatIsNoNumberIsLeftOut() {
    QFETCH(double, now_s);
    SeriesStore store;
    store.add(f1);
    QVERIFY(!store.take(timeless(), Seconds(now_s)));
    QVERIFY(store.series()[0].samples.empty());
    QVERIFY(!store.newestTime_s());
}

void tst_SeriesStore::lateValuesAreLeftOut() {
    SeriesStore store;
    store.add(f1);
    store.take(sonar(10.0, "1"), Seconds(0));
    store.take(sonar(9.5, "2"), Seconds(0));
    store.take(sonar(10.5, "3"), Seconds(0));
    QCOMPARE(store.series()[0].samples.size(), 2U);
    QCOMPARE(store.newestTime_s(), std::optional(10.5));
}

void tst_SeriesStore::aClockThatBeginsAgainStartsNewHistories() {
    SeriesStore store;
    store.add(f1);
    store.take(sonar(100.0, "1"), Seconds(0));
    const auto before = store.series()[0].history;
    store.take(sonar(0.2, "2"), Seconds(0));
    QCOMPARE(store.series()[0].samples.size(), 1U);
    QVERIFY(store.series()[0].history != before);
    QCOMPARE(store.oldestTime_s(), std::optional(0.2));
    QCOMPARE(store.newestTime_s(), std::optional(0.2));
}

void tst_SeriesStore::oldestFallOffTheRing() {
    SeriesStore store(3);
    store.add(f1);
    for (int i = 1; i <= 5; ++i)
        store.take(sonar(i, "1"), Seconds(0));
    QCOMPARE(store.series()[0].samples.size(), 3U);
    QCOMPARE(store.series()[0].dropped, 2U);
    QCOMPARE(store.oldestTime_s(), std::optional(3.0));
}

void tst_SeriesStore::removedAndAddedAgainIsAnotherHistory() {
    SeriesStore store;
    store.add(f1);
    const auto before = store.series()[0].history;
    store.remove(f1);
    store.add(f1);
    QVERIFY(store.series()[0].history != before);
}

void tst_SeriesStore::valueAtIsTheNewestUntilThen() {
    Series series;
    QVERIFY(!valueAt(series, 1.0));
    series.samples = {{1.0, 0.1}, {2.0, std::nan("")}, {3.0, 3.0}};
    QVERIFY(!valueAt(series, 0.9));
    QCOMPARE(valueAt(series, 1.0), std::optional(0.1));
    QCOMPARE(valueAt(series, 1.9), std::optional(0.1));
    QVERIFY(!valueAt(series, 2.5));
    QCOMPARE(valueAt(series, 1e9), std::optional(3.0));
}

void tst_SeriesStore::csvMergesTheTimes() {
    std::vector<Series> series(2);
    series[0].path = "a";
    series[0].unit = "m";
    series[0].samples = {{1.0, 0.1}, {2.0, std::nan("")}, {3.0, 3.0}};
    series[1].path = "b";
    series[1].samples = {{2.0, -20.0}, {2.5, 25.0}};
    QCOMPARE(csvOf(series), std::string("time_s,a [m],b\n1,0.1,\n2,,-20\n2.5,,25\n3,3,\n"));
}

void tst_SeriesStore::csvQuotesCommas() {
    std::vector<Series> series(1);
    series[0].path = "a,\"b\"";
    QCOMPARE(csvOf(series), std::string("time_s,\"a,\"\"b\"\"\"\n"));
}

void tst_SeriesStore::csvOfNothingIsAHeader() {
    QCOMPARE(csvOf({}), std::string("time_s\n"));
}

USAR_TEST(tst_SeriesStore)

} // namespace tst_series_store

#include "tst_series_store.moc"
