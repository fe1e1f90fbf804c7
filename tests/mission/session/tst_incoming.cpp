#include <QTest>

#include "core/mission/session/incoming.h"
#include "tests/suite/suite.h"

namespace tst_incoming {

using namespace usar;
using namespace usar::mission;

namespace {

constexpr const char* flying = "STA {Type AerialVehicle} {Time 2.50} {Battery 1200}";
constexpr const char* unknown = "WEATHER {Rain heavy}";
constexpr const char* damaged = "SEN {Time 2.50} {Type Sonar} {Name F1 Range 4.56"; // the braces are not closed

SessionFigures figuresOf(const Incoming& incoming) {
    SessionFigures figures;
    incoming.describe(figures);
    return figures;
}

} // namespace

class tst_Incoming : public QObject {
    Q_OBJECT
private slots:
    void aStateTellsTimeKindAndBattery() {
        Incoming incoming;
        QCOMPARE(incoming.kind(), protocol::VehicleKind::Unknown);
        QVERIFY(!incoming.batteryIsEmpty());
        incoming.take(flying);
        QCOMPARE(incoming.now().count(), 2.5);
        QCOMPARE(incoming.kind(), protocol::VehicleKind::Aerial);
        QVERIFY(!incoming.batteryIsEmpty());
        incoming.take("STA {Type AerialVehicle} {Time 2.60} {Battery 0}");
        QVERIFY(incoming.batteryIsEmpty());
        QCOMPARE(incoming.stateLine(), LineNumber{2});
        incoming.beginConnection();
        QCOMPARE(incoming.now().count(), 0.0);
        QCOMPARE(incoming.stateLine(), LineNumber{0});
    }

    void aBatteryIsToldInPercentOfTheMostItReported() {
        Incoming incoming;
        QVERIFY(!figuresOf(incoming).battery_left_pct);
        incoming.take(flying);
        QCOMPARE(figuresOf(incoming).battery_left_pct, std::optional(100.0));
        incoming.take("STA {Type AerialVehicle} {Time 2.60} {Battery 300}");
        QCOMPARE(figuresOf(incoming).battery_left_pct, std::optional(25.0));
        incoming.take("STA {Type AerialVehicle} {Time 2.70} {Battery 0}");
        QCOMPARE(figuresOf(incoming).battery_left_pct, std::optional(0.0));
        incoming.beginConnection();
        incoming.take("STA {Type GroundVehicle} {Time 2.50} {Battery 99999}");
        QVERIFY2(!figuresOf(incoming).battery_left_pct, "this robot has no battery");
        incoming.beginConnection();
        incoming.take("STA {Type AerialVehicle} {Time 0.20} {Battery 199998}");
        incoming.take("STA {Type AerialVehicle} {Time 99999.20} {Battery 99999}");
        QVERIFY2(figuresOf(incoming).battery_left_pct == 50.0, "this one has a long-lived battery");
    }

    void linesAreNumberedOverAllConnections() {
        Incoming incoming;
        QCOMPARE(incoming.take(flying).number, LineNumber{1});
        incoming.beginConnection();
        QCOMPARE(incoming.take(unknown).number, LineNumber{2});
        QCOMPARE(incoming.newest(), LineNumber{2});
        QCOMPARE(figuresOf(incoming).lines_received, std::uint64_t(2));
    }

    void damageIsToldOnceAndCountedByConnection() {
        Incoming incoming;
        incoming.beginConnection();
        QVERIFY(!incoming.judge(incoming.take(flying)));
        QVERIFY(incoming.judge(incoming.take(damaged)));
        QVERIFY(!incoming.judge(incoming.take(damaged)));
        QCOMPARE(figuresOf(incoming).traffic.malformed, std::uint64_t(2));
        incoming.beginConnection();
        QCOMPARE(figuresOf(incoming).traffic.malformed, std::uint64_t(0));
        QCOMPARE(figuresOf(incoming).lines_malformed, std::uint64_t(2));
        QVERIFY(!incoming.judge(incoming.take(damaged))); // known from the connection before
    }

    void unknownTypesAreCountedByConnection() {
        Incoming incoming;
        incoming.take(unknown);
        incoming.take(flying);
        QCOMPARE(figuresOf(incoming).traffic.unknown, std::uint64_t(1));
        incoming.beginConnection();
        QCOMPARE(figuresOf(incoming).traffic.unknown, std::uint64_t(0));
    }

    void aReplayBeginsAtTheNumberItHad() {
        Incoming incoming;
        incoming.judge(incoming.take(damaged));
        incoming.beginConnection();
        incoming.rewind();
        QCOMPARE(figuresOf(incoming).lines_received, std::uint64_t(0));
        QCOMPARE(figuresOf(incoming).lines_malformed, std::uint64_t(0));
        incoming.continueAfter({40});
        QCOMPARE(incoming.take(damaged).number, LineNumber{41});
        QCOMPARE(incoming.newest(), LineNumber{41});
    }
};

USAR_TEST(tst_Incoming)

} // namespace tst_incoming

#include "tst_incoming.moc"
