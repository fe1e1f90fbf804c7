// Marks of a robot under TRACE, from the commands that were sent and the poses that came.
#include <QTest>

#include "core/mission/fleet/trace_watch.h"
#include "tests/suite/suite.h"

namespace tst_trace_watch {

using namespace usar;
using namespace usar::mission;
using protocol::TraceColor;

namespace {

constexpr const char* on = "TRACE {On true} {Interval 0.5} {Color Green}";

/// An update of a session, put together line by line.
struct Update {
    SessionUpdate update;
    std::uint64_t lines = 0;

    Update& state(double time_s) { return line(protocol::RobotState{.time = Seconds(time_s)}); }
    Update& truth(double x_m) {
        protocol::GroundTruthReading reading;
        reading.base_in_map.position_m.x() = x_m;
        return line(reading);
    }
    Update& ins(double x_m) {
        protocol::InsReading reading;
        reading.base_in_map.position_m.x() = x_m;
        return line(reading);
    }
    Update& belief(double time_s, double x_m) {
        update.published.push_back(agent::PoseEstimate{Seconds(time_s), {Vec3(x_m, 0, 0)}});
        return *this;
    }
    Update& sent(const char* text) {
        update.commands.push_back({{}, text, LineNumber{lines}, Seconds{0.0}});
        return *this;
    }
    Update& line(const protocol::InfoMessage& message) {
        update.lines.push_back({{++lines}, "", message, {}});
        return *this;
    }
};

QStringList wordsOf(const std::vector<TraceSpot>& spots) {
    QStringList words;
    for (const TraceSpot& spot : spots)
        words << QString("%1 %2").arg(spot.position_in_map_m.x()).arg(int(spot.color));
    return words;
}

QString spot(double x_m, TraceColor color = TraceColor::Green) {
    return QString("%1 %2").arg(x_m).arg(int(color));
}

} // namespace

class tst_TraceWatch : public QObject {
    Q_OBJECT
private slots:
    void withoutACommandThereAreNoMarks() {
        TraceWatch watch;
        QVERIFY(watch.take(Update().state(1).truth(1).state(2).truth(2).update).empty());
        QVERIFY(!watch.on());
    }

    void marksAreAnIntervalAndAWayApart() {
        TraceWatch watch;
        Update update;
        update.sent(on).state(1.0).truth(1.0).state(1.2).truth(2.0).state(1.5).truth(3.0).state(2.0).truth(3.01);
        update.state(2.1).truth(4.0);
        QCOMPARE(wordsOf(watch.take(update.update)), (QStringList{spot(1.0), spot(3.0), spot(4.0)}));
        QVERIFY(watch.on());
        QCOMPARE(int(watch.color()), int(TraceColor::Green));
    }

    void aCommandCountsFromItsPlaceBetweenTheLines() {
        TraceWatch watch;
        Update update;
        update.state(1.0).truth(1.0).sent(on).state(2.0).truth(2.0).sent("TRACE {On false}").state(3.0).truth(3.0);
        QCOMPARE(wordsOf(watch.take(update.update)), QStringList{spot(2.0)});
        QVERIFY(!watch.on());
    }

    void aCommandAfterTheLastLineHoldsForTheNextUpdate() {
        TraceWatch watch;
        QVERIFY(watch.take(Update().state(1.0).truth(1.0).sent(on).update).empty());
        QVERIFY(watch.on());
        QCOMPARE(wordsOf(watch.take(Update().state(2.0).truth(2.0).update)), QStringList{spot(2.0)});
    }

    void whatIsLeftOutOfACommandStaysAsItWas() {
        TraceWatch watch;
        Update update;
        update.sent(on).state(1.0).truth(1.0).sent("trace {Color Red}").state(1.1).truth(2.0).state(1.3).truth(3.0);
        QCOMPARE(wordsOf(watch.take(update.update)), (QStringList{spot(1.0), spot(2.0, TraceColor::Red)}));
    }

    void theBestPoseCounts() {
        TraceWatch watch;
        QCOMPARE(wordsOf(watch.take(Update().sent(on).belief(1.0, 1.0).update)), QStringList{spot(1.0)});
        QCOMPARE(wordsOf(watch.take(Update().state(2.0).ins(2.0).belief(3.0, 9.0).update)), QStringList{spot(2.0)});
        QCOMPARE(wordsOf(watch.take(Update().state(4.0).truth(4.0).state(5.0).ins(9.0).update)),
                 QStringList{spot(4.0)});
    }

    void otherCommandsAndWordsAreNotObeyed_data() {
        QTest::addColumn<QByteArray>("command");
        for (const char* command : {"DRIVE {Left 1}", "TRACER {On true}", "TRACE {On true} {Color Pink}", "", "TRAC"})
            QTest::newRow(*command ? command : "nothing") << QByteArray(command);
    }

    void otherCommandsAndWordsAreNotObeyed() {
        QFETCH(QByteArray, command);
        TraceWatch watch;
        QVERIFY(watch.take(Update().sent(command.constData()).state(1.0).truth(1.0).update).empty());
        QVERIFY(!watch.on());
    }

    void aClockThatGoesBackLeavesAMark() {
        TraceWatch watch;
        Update update;
        update.sent(on).state(5.0).truth(1.0).state(1.0).truth(2.0);
        QCOMPARE(wordsOf(watch.take(update.update)), (QStringList{spot(1.0), spot(2.0)}));
    }

    void aRewoundReplayBeginsWithoutMarks() {
        TraceWatch watch;
        watch.take(Update().sent(on).state(1.0).truth(1.0).update);
        Update rewound;
        rewound.update.rewound = true;
        QVERIFY(watch.take(rewound.state(2.0).truth(2.0).update).empty());
        QVERIFY(!watch.on());
    }
};

USAR_TEST(tst_TraceWatch)

} // namespace tst_trace_watch

#include "tst_trace_watch.moc"
