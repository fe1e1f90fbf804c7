#include <QTest>

#include "core/mission/commands/outgoing.h"
#include "tests/suite/suite.h"

namespace tst_outgoing {

using namespace usar;
using namespace usar::mission;
using protocol::VehicleKind;

namespace {

struct Wire {
    Wire() { out.beginConnection(); }
    void send(const protocol::Command& command, const char* source = "test") {
        out.send({command, {by::Other{source}, {7}}});
    }

    QStringList lines; ///< "source: line", without the unit
    Outgoing out{[this](const agent::CausedCommand& command, std::string text) {
        lines << QString::fromStdString(toText(command.cause.source) + ": " + text).remove(" {Normalized false}");
    }};
};

QStringList textsOf(const std::vector<protocol::Command>& commands) {
    Wire wire;
    for (const protocol::Command& command : commands) {
        wire.send(command);
        wire.out.release(Seconds{0.0}, true);
    }
    return wire.lines;
}

} // namespace

class tst_Outgoing : public QObject {
    Q_OBJECT
private slots:
    void onlyDrivesWait() {
        Wire wire;
        wire.send(protocol::SkidDrive{1.0, 2.0}, "drives");
        wire.send(protocol::Step{}, "steps");
        QCOMPARE(wire.lines, QStringList{"steps: STEP"});
        wire.out.release(Seconds{1.0});
        QCOMPARE(wire.lines, (QStringList{"steps: STEP", "drives: DRIVE {Left 1} {Right 2}"}));
    }

    void drivesWaitForTheClockUnlessTheyAreReleased() {
        Wire wire;
        wire.send(protocol::SkidDrive{1.0, 1.0});
        wire.out.release(Seconds{1.0});
        wire.send(protocol::SkidDrive{2.0, 2.0});
        wire.out.release(Seconds{1.02});
        QCOMPARE(wire.lines.size(), 1);
        wire.out.release(Seconds{1.03}, true);
        QCOMPARE(wire.lines.size(), 2);
        wire.send(protocol::SkidDrive{3.0, 3.0});
        wire.out.release(Seconds{1.08});
        QCOMPARE(wire.lines.last(), QString("test: DRIVE {Left 3} {Right 3}"));
    }

    void whatWaitsCanBeDropped() {
        Wire wire;
        wire.send(protocol::SkidDrive{1.0, 1.0});
        wire.out.dropWaiting();
        wire.out.release(Seconds{1.0}, true);
        QVERIFY(wire.lines.isEmpty());
    }

    void replacedDrivesAreCountedByConnection() {
        Wire wire;
        for (const double speed : {1.0, 2.0, 3.0})
            wire.send(protocol::SkidDrive{speed, speed});
        QCOMPARE(wire.out.drivesReplaced(), std::uint64_t(2));
        wire.out.beginConnection();
        QCOMPARE(wire.out.drivesReplaced(), std::uint64_t(0));
        wire.out.release(Seconds{1.0}, true);
        QVERIFY(wire.lines.isEmpty()); // nothing of an old connection goes to a new one
    }

    void theServersDialectIsSpoken() {
        Wire wire;
        QVERIFY(!wire.out.dialect());
        QCOMPARE(wire.out.spelling(), protocol::Dialect::Ut2004);
        wire.out.heard("STA {Time 1.0000} {Battery 1200} {Type GroundVehicle}"); // it begins with its time in UDK only
        QCOMPARE(wire.out.dialect(), std::optional(protocol::Dialect::Udk));
        QCOMPARE(wire.out.spelling(), protocol::Dialect::Udk);
        wire.out.beginConnection();
        QVERIFY(!wire.out.dialect());
    }

    void aRobotIsStoppedByItsKind_data() {
        QTest::addColumn<int>("kind");
        QTest::addColumn<QStringList>("lines");
        const QString flight =
            "test: DRIVE {AltitudeVelocity 0} {LinearVelocity 0} {LateralVelocity 0} {RotationalVelocity 0}";
        const QString ground = "test: DRIVE {Left 0} {Right 0}";
        QTest::newRow("ground") << int(VehicleKind::Ground) << QStringList{ground};
        QTest::newRow("air") << int(VehicleKind::Aerial) << QStringList{flight};
        QTest::newRow("water") << int(VehicleKind::Nautic)
                               << QStringList{"test: DRIVE {Propeller 0} {Rudder 0} {SternPlane 0}"};
        QTest::newRow("legs") << int(VehicleKind::Legged) << QStringList{};
        QTest::newRow("unknown") << int(VehicleKind::Unknown) << QStringList{flight, ground};
    }

    void aRobotIsStoppedByItsKind() {
        QFETCH(int, kind);
        QFETCH(QStringList, lines);
        Wire wire;
        QCOMPARE(textsOf(wire.out.stops(std::nullopt, static_cast<VehicleKind>(kind))), lines);
    }

    void aSafeCommandTakesThePlaceOfAZeroDrive() {
        Wire wire;
        wire.send(protocol::SkidDrive{1.0, 1.0});
        wire.send(protocol::PackageDrive{"Arm", {{2, 0.5, protocol::LinkOrder::Speed}}});
        wire.out.release(Seconds{1.0}, true);
        QCOMPARE(textsOf(wire.out.stops(protocol::SkidDrive{0.1, 0.1}, VehicleKind::Ground)),
                 QStringList{"test: MISPKG {Name Arm} {Link 2} {Value 0} {Order 1}"});
    }

    void whatWasSentInMotionIsStoppedToo() {
        Wire wire;
        wire.send(protocol::AckermannDrive{2.0, 0.5, 0.0});
        QCOMPARE(wire.out.stops(std::nullopt, VehicleKind::Ground).size(),
                 std::size_t(1)); // it waits, so nothing moves
        wire.out.release(Seconds{1.0}, true);
        QCOMPARE(textsOf(wire.out.stops(std::nullopt, VehicleKind::Ground)),
                 (QStringList{"test: DRIVE {Left 0} {Right 0}", "test: DRIVE {Speed 0} {FrontSteer 0} {RearSteer 0}"}));
    }
};

USAR_TEST(tst_Outgoing)

} // namespace tst_outgoing

#include "tst_outgoing.moc"
