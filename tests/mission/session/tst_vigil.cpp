// What is missing in a session, by a clock of the test.
#include <QTest>

#include "tests/mission/session/session_parts.h"
#include "tests/suite/suite.h"

namespace tst_vigil {

using namespace usar;
using namespace usar::mission;

namespace {

using Topics = std::vector<std::string>;

struct Watched : test::NoticeBook {
    Watched() {
        SessionLimits limits;
        limits.greeting = Seconds{5.0};
        limits.stale = Seconds{2.0};
        limits.sensor_silence = Seconds{3.0};
        limits.unsent_bytes = 1000;
        vigil.setLimits(limits);
        vigil.beginConnection();
    }
    void hear(Seconds wall, Seconds now = Seconds{1.0}) { vigil.heardRobot(protocol::InsReading{}, "R1", now, wall); }
    /// STA of a server whose clock had reached `now` before.
    void hearTime(Seconds time, Seconds now) {
        protocol::RobotState state;
        state.time = time;
        vigil.heardRobot(state, "R1", now, Seconds{0.0});
    }

    Vigil vigil{notices};
};

} // namespace

class tst_Vigil : public QObject {
    Q_OBJECT
private slots:
    void startPosesAreMissedOnce() {
        Watched w;
        w.vigil.lookForStartPoses(Seconds{100.0}); // not reached yet
        w.vigil.connected(Seconds{100.0});
        w.vigil.lookForStartPoses(Seconds{105.0});
        QVERIFY(w.said.empty());
        w.vigil.lookForStartPoses(Seconds{105.1});
        w.vigil.lookForStartPoses(Seconds{111.0});
        QCOMPARE(w.topics(), Topics{"start poses"});
        QVERIFY(w.saidWords("No start poses from the server for 5 s. Is it USARSim"));
    }

    void startPosesThatCameAreNotMissed() {
        Watched w;
        w.vigil.connected(Seconds{0.0});
        w.vigil.heardStartPoses();
        w.vigil.lookForStartPoses(Seconds{100.0});
        QVERIFY(w.said.empty());
    }

    void startPosesThatComeLateEndTheComplaint() {
        Watched w;
        w.vigil.connected(Seconds{0.0});
        w.vigil.lookForStartPoses(Seconds{6.0});
        w.vigil.heardStartPoses();
        QCOMPARE(w.topics(), (Topics{"start poses", "-start poses"}));
    }

    void aSilentRobotIsReportedOncePerSilence() {
        Watched w;
        w.hear(Seconds{10.0});
        w.vigil.lookForRobot("R1", Seconds{12.0});
        QVERIFY(w.said.empty());
        w.vigil.lookForRobot("R1", Seconds{12.1});
        w.vigil.lookForRobot("R1", Seconds{20.0});
        QCOMPARE(w.topics(), Topics{"silence"});
        QVERIFY(w.saidWords("Nothing from R1 for 2 s: its values are stale."));
        w.hear(Seconds{21.0});
        w.vigil.lookForRobot("R1", Seconds{24.0});
        QCOMPARE(w.topics(), (Topics{"silence", "-silence", "silence"}));
    }

    void aRobotThatNeverSpokeIsNotSilent() {
        Watched w;
        w.vigil.lookForRobot("R1", Seconds{1000.0});
        QVERIFY(w.said.empty());
        QVERIFY(!w.vigil.silentFor(Seconds{1000.0}));
    }

    void expectedSilenceIsNoSilence() {
        Watched w;
        w.hear(Seconds{10.0});
        w.vigil.expectSilence(true, Seconds{10.5});
        w.vigil.lookForRobot("R1", Seconds{99.0});
        QVERIFY(w.said.empty());
    }

    void silenceBeforeExpectationEndsIsForgiven() {
        Watched w;
        w.hear(Seconds{10.0});
        w.vigil.expectSilence(true, Seconds{10.5});
        w.vigil.expectSilence(false, Seconds{99.0});
        w.vigil.lookForRobot("R1", Seconds{100.9});
        QVERIFY(w.said.empty());
        w.vigil.lookForRobot("R1", Seconds{101.1});
        QCOMPARE(w.topics(), Topics{"silence"});
    }

    void whatWasOurFaultIsForgiven() {
        Watched w;
        w.hear(Seconds{10.0});
        w.vigil.forgive(Seconds{50.0});
        QCOMPARE(w.vigil.silentFor(Seconds{51.5})->count(), 1.5);
        w.vigil.lookForRobot("R1", Seconds{51.5});
        QVERIFY(w.said.empty());
    }

    void aNewConnectionIsWatchedAnew() {
        Watched w;
        w.vigil.connected(Seconds{0.0});
        w.vigil.lookForStartPoses(Seconds{6.0});
        w.vigil.beginConnection();
        w.vigil.connected(Seconds{50.0});
        w.vigil.lookForStartPoses(Seconds{54.0});
        QCOMPARE(w.said.size(), std::size_t(1));
        w.vigil.lookForStartPoses(Seconds{56.0});
        QCOMPARE(w.said.size(), std::size_t(2));
    }

    void aSilentSensorIsNamed_data() {
        QTest::addColumn<bool>("battery_is_empty");
        QTest::addColumn<QString>("remark");
        QTest::newRow("of a robot that works") << false << "Stop the robot if it needs this sensor.";
        QTest::newRow("of a robot without power") << true << "The battery is empty.";
    }

    void aSilentSensorIsNamed() {
        QFETCH(bool, battery_is_empty);
        QFETCH(QString, remark);
        Watched w;
        w.hear(Seconds{0.0}, Seconds{10.0});
        w.vigil.lookForSensors(Seconds{13.0}, battery_is_empty);
        QVERIFY(w.said.empty());
        w.vigil.lookForSensors(Seconds{13.1}, battery_is_empty); // by the robot's clock, whatever the wall says
        QCOMPARE(w.topics(), Topics{"sensor: INS"});
        QVERIFY(
            w.saidWords(qPrintable("No reading from INS for 3 s of the robot's time; the last value stays, marked as "
                                   "old. " +
                                   remark)));
        w.hear(Seconds{0.1}, Seconds{13.2});
        QCOMPARE(w.topics(), (Topics{"sensor: INS", "-sensor: INS"}));
    }

    void timeThatGoesBackwardIsReportedUntilItHasCaughtUp() {
        Watched w;
        w.hearTime(Seconds{99.9}, Seconds{100.0}); // late by a tick
        w.hearTime(Seconds{1.0}, Seconds{100.0});  // damaged: the next one is right again
        w.hearTime(Seconds{100.2}, Seconds{100.2});
        QVERIFY(w.said.empty());
        for (const double time_s : {0.2, 0.4, 0.6, 0.8, 1.0})
            w.hearTime(Seconds{time_s}, Seconds{100.2});
        QCOMPARE(w.topics(), Topics{"clock"});
        QVERIFY(w.saidWords("The server's time went back from 100.2 s to 0.6 s."));
        w.hearTime(Seconds{100.4}, Seconds{100.4});
        QCOMPARE(w.topics(), (Topics{"clock", "-clock"}));
    }

    void aNewConnectionMayBeginAtAnEarlierTime() {
        Watched w;
        w.hearTime(Seconds{1.0}, Seconds{50.0});
        w.hearTime(Seconds{1.2}, Seconds{50.0});
        w.vigil.beginConnection();
        w.hearTime(Seconds{1.4}, Seconds{50.0}); // the last one of the old connection
        w.hearTime(Seconds{0.2}, Seconds{0.2});
        QVERIFY(w.said.empty());
    }

    void aFullQueueIsReportedUntilItIsEmpty() {
        Watched w;
        w.vigil.lookAtQueue(1000, "sim:3000");
        QVERIFY(w.said.empty());
        w.vigil.lookAtQueue(5400, "sim:3000");
        w.vigil.lookAtQueue(6000, "sim:3000");
        w.vigil.lookAtQueue(10, "sim:3000"); // not before all of it is read
        QCOMPARE(w.topics(), Topics{"queue"});
        QVERIFY(w.saidWords("The server at sim:3000 reads more slowly than commands are sent: 5 kB are waiting."));
        w.vigil.lookAtQueue(0, "sim:3000");
        QCOMPARE(w.topics(), (Topics{"queue", "-queue"}));
    }

    void eachOverlongLineIsReported() {
        Watched w;
        w.vigil.lookAtOverlong(0);
        QVERIFY(w.said.empty());
        w.vigil.lookAtOverlong(1);
        w.vigil.lookAtOverlong(1);
        w.vigil.lookAtOverlong(3);
        QCOMPARE(w.topics(), (Topics{"overlong", "overlong"}));
        QCOMPARE(w.vigil.overlong(), std::uint64_t(3));
        w.vigil.rewind();
        QCOMPARE(w.vigil.overlong(), std::uint64_t(0));
    }
};

USAR_TEST(tst_Vigil)

} // namespace tst_vigil

#include "tst_vigil.moc"
