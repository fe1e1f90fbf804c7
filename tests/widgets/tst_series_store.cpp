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

const std::string robot = "R1";
const SeriesKey f1{robot, "SEN Sonar/F1/range"};

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
    void recordsOnlyWhatIsWatched();
    void recordsEachRobotForItself();
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
};

void tst_SeriesStore::recordsOnlyWhatIsWatched() {
    SeriesStore store;
    QVERIFY(!store.take(robot, sonar(1.0, "2.0"), Seconds(0)));
    store.add(f1);
    QVERIFY(store.take(robot, sonar(2.0, "2.5"), Seconds(0)));
    QCOMPARE(store.series().size(), 1U);
    QCOMPARE(store.series()[0].samples.size(), 1U);
    QVERIFY(store.series()[0].samples.at(2.0) == std::optional(Reading{2.5, true}));
    store.add({robot, "SEN Sonar/F9/range"});
    QVERIFY(store.take(robot, sonar(3.0, "2.5"), Seconds(0)));
    QVERIFY(store.series()[1].samples.empty());
}

void tst_SeriesStore::recordsEachRobotForItself() {
    SeriesStore store;
    store.add(f1);
    QVERIFY(!store.take("R2", sonar(1.0, "2.0"), Seconds(0)));
    QVERIFY(store.series()[0].samples.empty());
    QVERIFY(!store.newestTime_s("R2"));
    QVERIFY(store.take(robot, sonar(1.0, "2.0"), Seconds(0)));
    store.startAgain("R2");
    QCOMPARE(store.series()[0].samples.size(), 1U);
    store.startAgain(robot);
    QVERIFY(store.series()[0].samples.empty());
}

void tst_SeriesStore::learnsTheUnit() {
    SeriesStore store;
    store.add(f1);
    store.take(robot, sonar(1.0, "2.0"), Seconds(0));
    QCOMPARE(store.series()[0].unit, std::string("m"));
}

void tst_SeriesStore::watchesAPathOnce() {
    SeriesStore store;
    QVERIFY(store.add(f1));
    QVERIFY(!store.add(f1));
    QVERIFY(!store.add({robot, ""}));
    QVERIFY(store.add({"R2", f1.path})); // of another robot
    store.keepOnly({{"R2", f1.path}});
    QVERIFY(!store.find(f1));
    QVERIFY(store.find({"R2", f1.path}));
}

void tst_SeriesStore::messagesWithoutTimeAreStampedWithNow() {
    SeriesStore store;
    store.add(f1);
    store.take(robot, timeless(), Seconds(7.5));
    QCOMPARE(store.series()[0].samples.newest_s(), 7.5);
}

void tst_SeriesStore::notANumberIsAGap() {
    SeriesStore store;
    store.add(f1);
    store.take(robot, sonar(1.0, "nan"), Seconds(0));
    QCOMPARE(store.series()[0].samples.size(), 1U);
    QVERIFY(std::isnan(store.series()[0].samples.knownSamples()[0].value));
}

void tst_SeriesStore::flagsAreZeroAndOne() {
    SeriesStore store;
    store.add({robot, "NFO//lockstep"});
    store.add({robot, "NFO/lockstep"});
    protocol::Reader reader;
    store.take(robot, reader.read("NFO {Lockstep True}"), Seconds(1));
    store.take(robot, reader.read("NFO {Lockstep False}"), Seconds(2));
    std::vector<double> values;
    for (const Series& series : store.series())
        for (const Sample& sample : series.samples.knownSamples())
            values.push_back(sample.value);
    QCOMPARE(values, (std::vector<double>{1.0, 0.0}));
}

void tst_SeriesStore::textsAreLeftOut() {
    protocol::Reader reader;
    const protocol::InfoLine line = reader.read("SEN {Time 1} {Type GPS} {Name G} {Latitude 39,8.03,N}");
    SeriesStore store;
    store.add({robot, "SEN GPS/G/Latitude"});
    store.take(robot, line, Seconds(0));
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
    QVERIFY(!store.take(robot, timeless(), Seconds(now_s)));
    QVERIFY(store.series()[0].samples.empty());
    QVERIFY(!store.newestTime_s(robot));
}

void tst_SeriesStore::lateValuesAreLeftOut() {
    SeriesStore store;
    store.add(f1);
    store.take(robot, sonar(10.0, "1"), Seconds(0));
    store.take(robot, sonar(9.5, "2"), Seconds(0));
    store.take(robot, sonar(10.5, "3"), Seconds(0));
    QCOMPARE(store.series()[0].samples.size(), 2U);
    QCOMPARE(store.newestTime_s(robot), std::optional(10.5));
}

void tst_SeriesStore::aClockThatBeginsAgainStartsNewHistories() {
    SeriesStore store;
    store.add(f1);
    store.take(robot, sonar(100.0, "1"), Seconds(0));
    store.add({"R2", f1.path});
    store.take("R2", sonar(100.0, "1"), Seconds(0));
    store.take(robot, sonar(0.2, "2"), Seconds(0));
    QCOMPARE(store.series()[0].samples.size(), 1U);
    QCOMPARE(store.series()[0].samples.oldest_s(), 0.2);
    QCOMPARE(store.newestTime_s("R2"), std::optional(100.0));
    QCOMPARE(store.newestTime_s(robot), std::optional(0.2));
}

USAR_TEST(tst_SeriesStore)

} // namespace tst_series_store

#include "tst_series_store.moc"
