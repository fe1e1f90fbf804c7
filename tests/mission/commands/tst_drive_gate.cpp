#include <QTest>

#include "core/mission/commands/drive_gate.h"
#include "core/protocol/command_writer.h"
#include "tests/suite/suite.h"

namespace tst_drive_gate {

using namespace usar;
using usar::mission::DriveGate;

namespace {

agent::CausedCommand drive(const protocol::AerialDrive& command, const char* source = "test") {
    return {command, {by::Other{source}, {}}};
}

template <class Drive = protocol::AerialDrive>
Drive released(const std::vector<agent::CausedCommand>& commands) {
    return commands.size() == 1 ? std::get<Drive>(commands.front().command) : Drive{};
}

/// What goes out after these were offered at once, as lines.
QByteArrayList linesOf(std::initializer_list<protocol::Command> drives) {
    DriveGate gate;
    for (const protocol::Command& command : drives)
        gate.offer({command, {}});
    QByteArrayList lines;
    for (const agent::CausedCommand& command : gate.release(Seconds{1.0}))
        lines << QByteArray::fromStdString(protocol::write(command.command)).replace(" {Normalized false}", "");
    return lines;
}

} // namespace

class tst_DriveGate : public QObject {
    Q_OBJECT
private slots:
    void knowsWhatDrives() {
        QVERIFY(protocol::isDrive(protocol::AerialDrive{}));
        QVERIFY(protocol::isDrive(protocol::SkidDrive{}));
        QVERIFY(protocol::isDrive(protocol::MultiDrive{}));
        QVERIFY(protocol::isDrive(protocol::JointDrive{"Knee"}));
        QVERIFY(protocol::isDrive(protocol::DriveSwitches{}));
        QVERIFY(!protocol::isDrive(protocol::PackageDrive{"Arm"}));
        QVERIFY(!protocol::isDrive(protocol::Step{}));
        QVERIFY(!protocol::isDrive(protocol::SetInsPose{}));
    }

    void letsEveryTickOfASimulatorPass() {
        DriveGate gate;
        for (int tick = 1; tick <= 50; ++tick) {
            gate.offer(drive({.forward_m_s = tick}));
            const auto command = gate.release(Seconds{tick * 0.2});
            QCOMPARE(released(command).forward_m_s, std::optional(double(tick)));
        }
    }

    void keepsToTwentyPerSecond() {
        DriveGate gate;
        int sent = 0;
        for (int step = 0; step < 200; ++step) { // two seconds of a teleoperator at 100 Hz
            gate.offer(drive({.forward_m_s = step}));
            sent += static_cast<int>(gate.release(Seconds{step * 0.01}).size());
        }
        QVERIFY2(sent >= 38 && sent <= 41, qPrintable(QString::number(sent)));
    }

    void keepsTheNewestAndTheTermsItLeavesOut() {
        DriveGate gate;
        gate.offer(drive({.climb_m_s = 1.0, .forward_m_s = 2.0}, "older"));
        gate.offer(drive({.forward_m_s = 3.0, .yaw_rate_rad_s = 0.5}, "newer"));
        const auto command = gate.release(Seconds{1.0});
        QCOMPARE(released(command),
                 (protocol::AerialDrive{.climb_m_s = 1.0, .forward_m_s = 3.0, .yaw_rate_rad_s = 0.5}));
        QCOMPARE(toText(command.front().cause.source), std::string("newer"));
        QVERIFY(gate.release(Seconds{2.0}).empty());
    }

    void keepsTheSideThatANewerSkidDriveLeavesOut() {
        const auto releasedSkid = [](DriveGate& gate) {
            return released<protocol::SkidDrive>(gate.release(Seconds{1.0}, true));
        };
        DriveGate gate;
        gate.offer({protocol::SkidDrive{.left_rad_s = 1.0}, {by::Other{"left"}, {}}});
        gate.offer({protocol::SkidDrive{.right_rad_s = 2.0}, {by::Other{"right"}, {}}});
        QCOMPARE(releasedSkid(gate), (protocol::SkidDrive{.left_rad_s = 1.0, .right_rad_s = 2.0}));
        gate.offer({protocol::SkidDrive{.left_rad_s = 100.0, .normalized = true}, {by::Other{"per cent"}, {}}});
        gate.offer({protocol::SkidDrive{.right_rad_s = 2.0}, {by::Other{"radians"}, {}}});
        QCOMPARE(releasedSkid(gate), (protocol::SkidDrive{.right_rad_s = 2.0}));
    }

    void neverMixesPercentWithMetres() {
        DriveGate gate;
        gate.offer(drive({.climb_m_s = 100.0, .normalized = true}));
        gate.offer(drive({.forward_m_s = 3.0}));
        QCOMPARE(released(gate.release(Seconds{1.0})), (protocol::AerialDrive{.forward_m_s = 3.0}));
    }

    void opensForAClockThatRanBackward() {
        DriveGate gate;
        gate.offer(drive({.forward_m_s = 1.0}));
        QVERIFY(!gate.release(Seconds{500.0}).empty());
        gate.offer(drive({.forward_m_s = 2.0}));
        QVERIFY(!gate.release(Seconds{0.2}).empty());
    }

    void canBeToldNotToWait() {
        DriveGate gate;
        gate.offer(drive({.forward_m_s = 1.0}));
        QVERIFY(!gate.release(Seconds{1.0}).empty());
        gate.offer(drive({.forward_m_s = 0.0}));
        QVERIFY(gate.release(Seconds{1.0}).empty());
        QVERIFY(!gate.release(Seconds{1.0}, true).empty());
        QVERIFY(gate.release(Seconds{1.0}, true).empty());
    }

    void eachKindIsKeptToTwentyPerSecond() {
        DriveGate gate;
        std::map<std::size_t, int> sent;
        for (int step = 0; step < 200; ++step) { // two seconds at 100 Hz
            const double value = step;
            for (const protocol::Command& command : std::initializer_list<protocol::Command>{
                     protocol::SkidDrive{value, value}, protocol::JointDrive{"Pan", protocol::JointOrder::Speed, value},
                     protocol::MultiDrive{{{"FLFlipper", value}}}})
                gate.offer({command, {}});
            for (const agent::CausedCommand& command : gate.release(Seconds{step * 0.01}))
                ++sent[command.command.index()];
        }
        QCOMPARE(sent.size(), std::size_t{3});
        for (const auto& [kind, count] : sent)
            QVERIFY2(count >= 38 && count <= 41, qPrintable(QString::number(count)));
    }

    void kindsDoNotOverwriteEachOther_data() {
        using namespace protocol;
        QTest::addColumn<QByteArrayList>("lines");
        QTest::addColumn<QByteArrayList>("expected");
        const auto row = [](const char* name, std::initializer_list<Command> drives, const QByteArrayList& expected) {
            QTest::newRow(name) << linesOf(drives) << expected;
        };
        row("air and ground", {AerialDrive{.climb_m_s = 1.0}, SkidDrive{.right_rad_s = 2.0}},
            {"DRIVE {AltitudeVelocity 1}", "DRIVE {Right 2}"});
        row("a car keeps its steering", {AckermannDrive{.front_steer_rad = 0.5}, AckermannDrive{.speed_rad_s = 2.0}},
            {"DRIVE {Speed 2} {FrontSteer -0.5}"});
        row("a boat keeps its rudder", {NauticDrive{.rudder_rad = 0.5}, NauticDrive{.propeller_rad_s = 2.0}},
            {"DRIVE {Propeller 2} {Rudder 0.5}"});
        row("an attitude stays", {AerialDrive{.pitch_rad = 0.0}, AerialDrive{.climb_m_s = 1.0}},
            {"DRIVE {AltitudeVelocity 1} {PitchAngle 0}"});
        row("wheels one by one",
            {OmniDrive{{{0, 1.0, {}}, {1, 2.0, {}}}}, OmniDrive{{{1, 3.0, {}}}}, OmniDrive{{{0, {}, -0.5}}}},
            {"DRIVE {WheelNumber 0} {WheelSpeed 1} {WheelSteer 0.5} {WheelNumber 1} {WheelSpeed 3}"});
        row("joints of a MULTIDRIVE", {MultiDrive{{{"A", 1.0}, {"B", 2.0}}}, MultiDrive{{{"B", 3.0}, {"C", 4.0}}}},
            {"MULTIDRIVE {B 3} {C 4} {A 1}"});
        row("joints by name",
            {JointDrive{"A", JointOrder::Angle, 1.0}, JointDrive{"B", JointOrder::Angle, 2.0},
             JointDrive{"A", JointOrder::Angle, 3.0}},
            {"DRIVE {Name B} {Order 0} {Value 2}", "DRIVE {Name A} {Order 0} {Value 3}"});
        row("relative orders add up",
            {JointDrive{"A", JointOrder::RelativeAngle, 0.25}, JointDrive{"A", JointOrder::RelativeAngle, 0.5}},
            {"DRIVE {Name A} {Order 10} {Value 0.75}"});
        row("a joint of both commands: the newer counts",
            {MultiDrive{{{"A", 1.0}, {"B", 2.0}}}, JointDrive{"A", JointOrder::Angle, 3.0}, MultiDrive{{{"B", 4.0}}}},
            {"DRIVE {Name A} {Order 0} {Value 3}", "MULTIDRIVE {B 4}"});
        row("a joint named, then with others", {JointDrive{"A", JointOrder::Angle, 3.0}, MultiDrive{{{"A", 1.0}}}},
            {"MULTIDRIVE {A 1}"});
        row("lights stay", {SkidDrive{.left_rad_s = 1.0, .switches = {true, {}}}, SkidDrive{.left_rad_s = 2.0}},
            {"DRIVE {Left 2} {Light true}"});
        row("lights of two commands: the newer counts",
            {SkidDrive{.left_rad_s = 1.0, .switches = {false, {}}}, DriveSwitches{true, {}},
             SkidDrive{.left_rad_s = 2.0}},
            {"DRIVE {Light true}", "DRIVE {Left 2}"});
        row("lights said twice", {DriveSwitches{false, {}}, SkidDrive{.left_rad_s = 1.0, .switches = {true, {}}}},
            {"DRIVE {Left 1} {Light true}"});
    }

    void kindsDoNotOverwriteEachOther() {
        QFETCH(QByteArrayList, lines);
        QFETCH(QByteArrayList, expected);
        QCOMPARE(lines, expected);
    }

    /// UDK acts on all three terms only.
    void aCarsTermsAreFilledUpFromWhatWasSent() {
        DriveGate gate;
        gate.offer({protocol::AckermannDrive{2.0, 0.5, -0.5}, {}});
        gate.release(Seconds{1.0}, true);
        gate.offer({protocol::AckermannDrive{.speed_rad_s = 1.0}, {}});
        QVERIFY(released<protocol::AckermannDrive>(gate.release(Seconds{2.0}, true)) ==
                (protocol::AckermannDrive{1.0, 0.5, -0.5}));
        gate.reset();
        gate.offer({protocol::AckermannDrive{.speed_rad_s = 1.0}, {}});
        QVERIFY(released<protocol::AckermannDrive>(gate.release(Seconds{3.0}, true)) ==
                (protocol::AckermannDrive{.speed_rad_s = 1.0}));
    }

    void saysWhetherOneWasReplaced() {
        DriveGate gate;
        QVERIFY(!gate.offer(drive({.forward_m_s = 1.0})));
        QVERIFY(!gate.offer({protocol::DriveSwitches{true, {}}, {}}));
        QVERIFY(gate.offer(drive({.forward_m_s = 2.0})));
    }
};

USAR_TEST(tst_DriveGate)

} // namespace tst_drive_gate

#include "tst_drive_gate.moc"
