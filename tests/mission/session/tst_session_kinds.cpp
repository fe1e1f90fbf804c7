#include <QTest>

#include "core/mission/commands/safe_stop.h"
#include "core/protocol/command_reader.h"
#include "core/protocol/command_writer.h"
#include "session_fixture.h"
#include "tests/suite/suite.h"

namespace tst_session_kinds {

using namespace usar;
using namespace usar::mission;
using usar::protocol::Command;
using usar::protocol::Dialect;
using usar::test::SessionFixture;

namespace {

constexpr const char* udk_state = "STA {Time 1.0000} {Battery 1200} {Type GroundVehicle}\r\n";

/// Without the unit, which all of them name.
QByteArrayList drivesOf(const SessionFixture& f) {
    QByteArrayList drives;
    for (QByteArray line : f.server.heardOf("DRIVE") + f.server.heardOf("MISPKG"))
        drives << line.replace(" {Normalized false}", "");
    return drives;
}

/// Spawns a robot that answers with this state only.
bool spawnAs(SessionFixture& f, const QByteArray& state) {
    f.server.answers_init = false;
    f.server.on_command = [&f, state](const QByteArray& line) {
        if (line.startsWith("INIT"))
            f.server.say(state);
    };
    if (!f.connectNow())
        return false;
    f.session.spawn({.start_in_map = {}});
    return QTest::qWaitFor([&] { return f.session.figures().spawned; });
}

} // namespace

class tst_SessionKinds : public QObject {
    Q_OBJECT
private slots:
    void closingStopsARobotOfAnyKindFirst_data() {
        QTest::addColumn<QByteArray>("state");
        QTest::addColumn<QByteArrayList>("before");
        QTest::addColumn<QByteArrayList>("stops");
        const auto row = [](const char* name, const char* state, const QByteArrayList& before,
                            const QByteArrayList& stops) {
            QTest::newRow(name) << QByteArray(state) + "\r\n" << before << stops;
        };
        const char* const ground = "STA {Type GroundVehicle} {Time 1.00}";
        const char* const legged = "STA {Type LeggedRobot} {Time 1.00}";
        const char* const platform = "STA {Type StaticPlatform} {Time 1.00}";
        const char* const flight =
            "DRIVE {AltitudeVelocity 0} {LinearVelocity 0} {LateralVelocity 0} {RotationalVelocity 0}";
        row("on two sides", ground, {}, {"DRIVE {Left 0} {Right 0}"});
        row("in the air", "STA {Type AerialVehicle} {Time 1.00}", {}, {flight});
        row("in the water", "STA {Type NauticVehicle} {Time 1.00}", {},
            {"DRIVE {Propeller 0} {Rudder 0} {SternPlane 0}"});
        row("of no known kind", "STA {Time 1.0000} {Battery 1200}", {}, {flight, "DRIVE {Left 0} {Right 0}"});
        row("on legs, at rest", legged, {}, {});
        row("on legs, a joint at a speed", legged, {"DRIVE {Name Knee} {Order 1} {Value 2}"},
            {"DRIVE {Name Knee} {Order 1} {Value 0}"});
        row("on legs, joints on their way", legged, {"MULTIDRIVE {A 1} {B 2}"},
            {"DRIVE {Name A} {Order 10} {Value 0}", "DRIVE {Name B} {Order 10} {Value 0}"});
        row("bolted down, an arm at a speed", platform, {"MISPKG {Name Arm} {Link 2} {Value 0.5} {Order 1}"},
            {"MISPKG {Name Arm} {Link 2} {Value 0} {Order 1}"});
        row("a car", ground, {"DRIVE {Speed 2} {FrontSteer 0.5}"},
            {"DRIVE {Left 0} {Right 0}", "DRIVE {Speed 0} {FrontSteer 0} {RearSteer 0}"});
        row("a car that turns on its wheels", ground,
            {"DRIVE {WheelNumber 0} {WheelSpeed 3} {WheelNumber 2} {WheelSpeed 1}"},
            {"DRIVE {Left 0} {Right 0}", "DRIVE {WheelNumber 0} {WheelSpeed 0} {WheelNumber 2} {WheelSpeed 0}"});
    }

    void closingStopsARobotOfAnyKindFirst() {
        QFETCH(QByteArray, state);
        QFETCH(QByteArrayList, before);
        QFETCH(QByteArrayList, stops);
        SessionFixture f(SessionFixture::patientLimits());
        QVERIFY(spawnAs(f, state));
        for (const QByteArray& line : before)
            f.session.sendCommand(protocol::RawCommand{line.toStdString()}, by::Other{"test"});
        f.session.close();
        QTRY_VERIFY(!f.server.hasClient());
        QByteArrayList drives = drivesOf(f);
        for (const QByteArray& line : before)
            drives.removeOne(line);
        QCOMPARE(drives, stops);
    }

    void aBehaviorsSafeCommandIsNotOverruled() {
        SessionFixture f(SessionFixture::patientLimits());
        const auto script = std::make_shared<test::Script>();
        script->safe = protocol::AerialDrive{-0.5, 0.0, 0.0, 0.0}; // sinks
        QVERIFY(spawnAs(f, "STA {Type AerialVehicle} {Time 1.00}\r\n"));
        f.session.sendCommand(protocol::AerialDrive{.climb_m_s = 1.0}, by::Other{"test"});
        f.session.sendCommand(protocol::RawCommand{"DRIVE {Name Rotor} {Order 1} {Value 2}"}, by::Other{"test"});
        f.session.startBehavior(test::hostOf(script), {});
        f.session.close();
        QTRY_VERIFY(!f.server.hasClient());
        const QByteArrayList drives = drivesOf(f);
        QVERIFY2(drives.contains("DRIVE {Name Rotor} {Order 1} {Value 0}"), drives.join("; "));
        QVERIFY2(drives.at(drives.size() - 2).contains("{AltitudeVelocity -0.5}"), drives.join("; "));
        QVERIFY(!drives.join("; ").contains("{AltitudeVelocity 0}"));
    }

    void rememberedStopsAreOneForEachThing() {
        MovingParts parts;
        for (int i = 0; i < 100; ++i) {
            parts.sent(protocol::SkidDrive{1.0, i});
            parts.sent(protocol::SetJoint{"Knee", protocol::JointOpcode::Speed, 1.0});
            parts.sent(protocol::JointDrive{"Wheel", protocol::JointOrder::Brake, 5.0}); // it keeps braking
            parts.sent(protocol::PackageDrive{"Arm", {{1, 0.5}, {2, 1.0, protocol::LinkOrder::Torque}}});
            parts.sent(protocol::OmniDrive{{{i % 3, 1.0, {}}}});
            for (const Command& stop : parts.stops())
                parts.sent(stop); // which sets nothing in motion
        }
        QCOMPARE(parts.stops().size(), std::size_t{4});
        QCOMPARE(std::get<protocol::OmniDrive>(parts.stops().back()).wheels.size(), std::size_t{3});
        parts.reset();
        QVERIFY(parts.stops().empty());
    }

    void twoServersAtOnceAreToldApart() {
        SessionFixture ut2004(SessionFixture::patientLimits());
        SessionFixture udk(SessionFixture::patientLimits());
        QVERIFY(spawnAs(ut2004, "STA {Type AerialVehicle} {Time 1.00} {Battery 1200} {View -1}\r\n"));
        QVERIFY(spawnAs(udk, udk_state));
        QCOMPARE(ut2004.session.figures().dialect, std::optional(Dialect::Ut2004));
        QCOMPARE(udk.session.figures().dialect, std::optional(Dialect::Udk));
        for (SessionFixture* f : {&ut2004, &udk}) {
            f->session.sendCommand(protocol::AerialDrive{.yaw_rate_rad_s = -pi / 2}, by::Other{"test"});
            QTRY_COMPARE(f->server.heardOf("DRIVE").size(), 1);
        }
        QCOMPARE(drivesOf(ut2004).at(0), QByteArray("DRIVE {RotationalVelocity 1.5707963267948966}"));
        QCOMPARE(drivesOf(udk).at(0), QByteArray("DRIVE {RotationalVelocity 90}"));
    }

    void aNewConnectionIsOfUnknownDialect() {
        SessionFixture f(SessionFixture::patientLimits());
        QVERIFY(spawnAs(f, udk_state));
        QVERIFY(f.session.figures().dialect.has_value());
        QVERIFY(f.connectNow());
        QVERIFY(!f.session.figures().dialect.has_value());
    }
};

USAR_TEST(tst_SessionKinds)

} // namespace tst_session_kinds

#include "tst_session_kinds.moc"
