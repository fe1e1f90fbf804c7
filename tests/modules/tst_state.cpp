#include <QTest>

#include "core/modules/state.h"
#include "core/protocol/reader.h"
#include "tests/suite/suite.h"

namespace tst_state {

using namespace usar;

class tst_State : public QObject {
    Q_OBJECT
private slots:
    void keepsTheNewestOfEveryPackageAndEffecter();
    void knowsNothingBeforeTheFirstState();
    void theNewestStateReplacesTheOld();
    void theClockNeverRunsBackward();
    void oneDamagedTimeDoesNotStopTheClock();
    void aJumpThatTheNextStateConfirmsIsBelieved();
    void aDamagedFirstTimeIsTakenBack();
    void otherLinesChangeNothing_data();
    void otherLinesChangeNothing();
};

void tst_State::knowsNothingBeforeTheFirstState() {
    const modules::StateModule state;
    QVERIFY(!state.latest());
    QCOMPARE(state.now().count(), 0.0);
    QCOMPARE(state.line().value, 0u);
}

void tst_State::theNewestStateReplacesTheOld() {
    protocol::Reader reader;
    modules::StateModule state;
    state.take(reader.read("STA {Type AerialVehicle} {Time 10.00} {Battery 1200} {View -1}"));
    state.take(reader.read("STA {Type AerialVehicle} {Time 10.20} {Battery 1199}"));
    QCOMPARE(state.latest()->battery_left->count(), 1199.0);
    QVERIFY(!state.latest()->view);
    QCOMPARE(state.now().count(), 10.2);
    QCOMPARE(state.line().value, 2u);
}

void tst_State::theClockNeverRunsBackward() {
    protocol::Reader reader;
    modules::StateModule state;
    state.take(reader.read("STA {Time 10.00} {Battery 5}"));
    state.take(reader.read("STA {Time 9.00} {Battery 4}"));
    state.take(reader.read("STA {Battery 3}"));
    QCOMPARE(state.now().count(), 10.0);
    QCOMPARE(state.latest()->battery_left->count(), 3.0);
}

namespace {

/// The clock after a state of each time.
std::vector<double> clockAfter(const std::vector<double>& times_s) {
    protocol::Reader reader;
    modules::StateModule state;
    std::vector<double> clock_s;
    for (const double time_s : times_s) {
        state.take(reader.read("STA {Time " + std::to_string(time_s) + "}"));
        clock_s.push_back(state.now().count());
    }
    return clock_s;
}

} // namespace

void tst_State::oneDamagedTimeDoesNotStopTheClock() {
    QCOMPARE(clockAfter({10.0, 10.5, 1050.0, 11.0, 11.5}), (std::vector<double>{10.0, 10.5, 10.5, 11.0, 11.5}));
    QCOMPARE(clockAfter({10.0, 500.0, 900.0, 11.0}), (std::vector<double>{10.0, 10.0, 10.0, 11.0}));
    QCOMPARE(clockAfter({10.0, 500.0, 11.0, 500.0, 12.0}), (std::vector<double>{10.0, 10.0, 11.0, 11.0, 12.0}));
}

void tst_State::aJumpThatTheNextStateConfirmsIsBelieved() {
    QCOMPARE(clockAfter({10.0, 75.0, 75.5, 76.0}), (std::vector<double>{10.0, 10.0, 75.5, 76.0}));
    QCOMPARE(clockAfter({10.0, 19.5}), (std::vector<double>{10.0, 19.5})); // no jump at all
}

void tst_State::aDamagedFirstTimeIsTakenBack() {
    QCOMPARE(clockAfter({5000.0, 10.0, 10.5, 11.0}), (std::vector<double>{5000.0, 5000.0, 10.5, 11.0}));
    QCOMPARE(clockAfter({50.0, 50.5, 10.0, 10.5}), (std::vector<double>{50.0, 50.5, 50.5, 50.5})); // it was confirmed
}

void tst_State::otherLinesChangeNothing_data() {
    QTest::addColumn<QByteArray>("line");
    QTest::newRow("a sensor with a later time") << QByteArray("SEN {Time 99} {Type Sonar} {Name F1 Range 1}");
    QTest::newRow("a mission package") << QByteArray("MISSTA {Time 99} {Name Cam} {Link 1} {Value 0}");
    QTest::newRow("the state of a box") << QByteArray("STA {Name Box1} {Size 1,1,1} {Time 99}");
    QTest::newRow("a state without words") << QByteArray("STA");
}

void tst_State::otherLinesChangeNothing() {
    QFETCH(QByteArray, line);
    protocol::Reader reader;
    modules::StateModule state;
    state.take(reader.read("STA {Time 10.00} {Battery 5}"));
    state.take(reader.read(line.toStdString()));
    QCOMPARE(state.now().count(), 10.0);
    QCOMPARE(state.line().value, 1u);
    QCOMPARE(state.latest()->battery_left->count(), 5.0);
}

void tst_State::keepsTheNewestOfEveryPackageAndEffecter() {
    protocol::Reader reader;
    modules::StateModule state;
    QVERIFY(!state.package("CameraPanTilt"));
    state.take(
        reader.read("MISSTA {Time 1} {Name CameraPanTilt} {Link 1} {Value 0.1} {Torque -20.00} {Link 2} {Value 0}"));
    state.take(reader.read("ASTA {Time 1} {Name Arm} {Link 1} {Value 0.5}"));
    state.take(reader.read("MISSTA {Time 2} {Name CameraPantilt} {Link 1} {Value 0.2} {Link 2} {Value -0.3}"));
    state.take(reader.read("EFF {Time 2} {Type Gripper} {Name G} {Status CLOSED}"));
    QCOMPARE(state.packages().size(), std::size_t(2));
    const protocol::PackageState* const camera = state.package("CameraPanTilt");
    QCOMPARE(camera->links.size(), std::size_t(2));
    QCOMPARE(camera->links[0].value, 0.2);
    QVERIFY(!camera->links[0].torque_n_m);
    QCOMPARE(camera->links[1].value, -0.3);
    QVERIFY(*state.effecter("G")->closed);
}

USAR_TEST(tst_State)

} // namespace tst_state

#include "tst_state.moc"
