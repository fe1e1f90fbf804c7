// When a replay plays what was recorded: as it arrived, or as slowly as the robot's clock ran.
#include <QTest>

#include "core/link/play_clock.h"
#include "tests/suite/suite.h"

namespace tst_play_clock {

using namespace usar;
using namespace usar::link;
using namespace std::chrono_literals;

namespace {

/// A record, and when it is to be played.
struct Played {
    RecordTime time;
    std::string bytes;
    RecordTime play;
    RecordKind kind = RecordKind::In;
};
using Run = std::vector<Played>;

} // namespace

class tst_PlayClock : public QObject {
    Q_OBJECT
private slots:
    void eachRecordHasItsMoment_data() {
        QTest::addColumn<Run>("run");
        QTest::newRow("without a clock as it arrived")
            << Run{{0s, "host:1", 0s, RecordKind::Opened}, {1s, "x", 1s}, {3s, "y", 3s}};
        QTest::newRow("a clock that runs faster") << Run{
            {1s, "{Time 10.0}", 1s}, {1100ms, "{Time 12.0}", 3s}, {1200ms, "{Time 13.0}", 4s}, {1300ms, "x", 4s}};
        QTest::newRow("a clock that runs slower") << Run{{1s, "{Time 10.0}", 1s}, {5s, "{Time 11.0}", 5s}};
        QTest::newRow("the longest leap") << Run{{1s, "{Time 10.0}", 1s}, {1500ms, "{Time 20.0}", 11s}};
        QTest::newRow("a longer one is not played")
            << Run{{1s, "{Time 10.0}", 1s}, {2s, "{Time 21.0}", 2s}, {3s, "{Time 22.0}", 3s}};
        QTest::newRow("counting goes on after the leap")
            << Run{{1s, "{Time 10.0}", 1s}, {2s, "{Time 50.0}", 2s}, {2100ms, "{Time 53.0}", 5s}};
        QTest::newRow("a clock that starts over") << Run{{1s, "{Time 10.0}", 1s},
                                                         {1100ms, "{Time 12.0}", 3s},
                                                         {1200ms, "{Time 0.0}", 3s},
                                                         {1300ms, "{Time 1.0}", 4s}};
        QTest::newRow("a new connection") << Run{{1s, "{Time 10.0}", 1s},
                                                 {1100ms, "{Time 12.0}", 3s},
                                                 {1200ms, "gone", 3s, RecordKind::Closed},
                                                 {2s, "host:1", 3s, RecordKind::Opened},
                                                 {3s, "x", 4s}};
        QTest::newRow("a clock cut off by the end of its chunk")
            << Run{{1s, "{Time 10.0}", 1s}, {1100ms, "{Time 15", 1100ms}};
        QTest::newRow("the last of a chunk counts")
            << Run{{1s, "{Time 1.0}\r\n{Time 3.0}\r\n", 1s}, {1100ms, "{Time 4.0}", 2s}};
        QTest::newRow("a clock without a number")
            << Run{{1s, "{Time 10.0}", 1s}, {2s, "{Time soon}", 2s}, {2100ms, "{Time 13.0}", 4s}};
        QTest::newRow("what was sent has no clock")
            << Run{{1s, "{Time 10.0}", 1s}, {1100ms, "{Time 15.0}", 1100ms, RecordKind::Out}};
        QTest::newRow("notes have none, either")
            << Run{{1s, "{Time 10.0}", 1s}, {1100ms, "{Time 15.0}", 1100ms, RecordKind::Note}};
        QTest::newRow("arrivals that run backward") << Run{{5s, "x", 5s}, {3s, "y", 5s}, {6s, "z", 6s}};
    }
    void eachRecordHasItsMoment() {
        QFETCH(Run, run);
        PlayClock clock;
        for (const Played& one : run)
            QCOMPARE(clock.at({.kind = one.kind, .time = one.time, .bytes = one.bytes}).count(), one.play.count());
    }

    void knowsTheNewestClockOfItsConnection() {
        PlayClock clock;
        QVERIFY(!clock.now());
        clock.at({.kind = RecordKind::In, .time = 1s, .bytes = "{Time 10.0}"});
        QVERIFY(clock.now() == Seconds{10.0});
        clock.at({.kind = RecordKind::In, .time = 2s, .bytes = "x"});
        QVERIFY(clock.now() == Seconds{10.0});
        clock.at({.kind = RecordKind::In, .time = 3s, .bytes = "{Time 2.5}"});
        QVERIFY(clock.now() == Seconds{2.5});
        clock.at({.kind = RecordKind::Opened, .time = 4s, .bytes = "host:1"});
        QVERIFY(!clock.now());
    }

    void neverRunsBackward() {
        PlayClock clock;
        RecordTime before{0};
        for (int i = 0; i < 3000; ++i) {
            const int clock_s = i * 7919 % 997; // leaps in both directions
            const RecordTime arrival = 100ms * (i + i * 31 % 17 - 8);
            const std::string bytes = i % 5 == 0 ? "x" : "{Time " + std::to_string(clock_s) + ".5}";
            const RecordKind kind = i % 97 == 0 ? RecordKind::Opened : RecordKind::In;
            const RecordTime play = clock.at({.kind = kind, .time = arrival, .bytes = bytes});
            QVERIFY2(play >= before, qPrintable(QString::number(i)));
            before = play;
        }
        QVERIFY(before >= RecordTime(290s)); // at least as long as the recording
    }
};

USAR_TEST(tst_PlayClock)

} // namespace tst_play_clock

#include "tst_play_clock.moc"
