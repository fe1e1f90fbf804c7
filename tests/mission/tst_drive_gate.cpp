#include <QTest>

#include "core/mission/drive_gate.h"

using namespace usar;
using usar::mission::DriveGate;

namespace {

agent::CausedCommand drive(const protocol::AerialDrive& command, const char* source = "test") {
    return {command, {source, {}}};
}

protocol::AerialDrive released(const std::optional<agent::CausedCommand>& command) {
    return std::get<protocol::AerialDrive>(command.value().command);
}

} // namespace

class tst_DriveGate : public QObject {
    Q_OBJECT
private slots:
    void knowsWhatDrives();
    void letsEveryTickOfASimulatorPass();
    void keepsToTwentyPerSecond();
    void keepsTheNewestAndTheTermsItLeavesOut();
    void keepsTheSideThatANewerSkidDriveLeavesOut();
    void neverMixesPercentWithMetres();
    void opensForAClockThatRanBackward();
    void canBeToldNotToWait();
};

void tst_DriveGate::knowsWhatDrives() {
    QVERIFY(DriveGate::isDrive(protocol::AerialDrive{}));
    QVERIFY(DriveGate::isDrive(protocol::SkidDrive{}));
    QVERIFY(!DriveGate::isDrive(protocol::Step{}));
    QVERIFY(!DriveGate::isDrive(protocol::SetInsPose{}));
}

void tst_DriveGate::letsEveryTickOfASimulatorPass() {
    DriveGate gate;
    for (int tick = 1; tick <= 50; ++tick) {
        gate.offer(drive({.forward_m_s = tick}));
        const auto command = gate.release(Seconds{tick * 0.2});
        QVERIFY(command);
        QCOMPARE(released(command).forward_m_s, std::optional(double(tick)));
    }
}

void tst_DriveGate::keepsToTwentyPerSecond() {
    DriveGate gate;
    int sent = 0;
    for (int step = 0; step < 200; ++step) { // two seconds of a teleoperator at 100 Hz
        gate.offer(drive({.forward_m_s = step}));
        sent += gate.release(Seconds{step * 0.01}) ? 1 : 0;
    }
    QVERIFY2(sent >= 38 && sent <= 41, qPrintable(QString::number(sent)));
}

void tst_DriveGate::keepsTheNewestAndTheTermsItLeavesOut() {
    DriveGate gate;
    gate.offer(drive({.climb_m_s = 1.0, .forward_m_s = 2.0}, "older"));
    gate.offer(drive({.forward_m_s = 3.0, .yaw_rate_rad_s = 0.5}, "newer"));
    QVERIFY(gate.holding());
    const auto command = gate.release(Seconds{1.0});
    QCOMPARE(released(command), (protocol::AerialDrive{.climb_m_s = 1.0, .forward_m_s = 3.0, .yaw_rate_rad_s = 0.5}));
    QCOMPARE(command->cause.source, std::string("newer"));
    QVERIFY(!gate.release(Seconds{2.0}));
}

void tst_DriveGate::keepsTheSideThatANewerSkidDriveLeavesOut() {
    const auto releasedSkid = [](DriveGate& gate) {
        return std::get<protocol::SkidDrive>(gate.releaseNow(Seconds{1.0}).value().command);
    };
    DriveGate gate;
    gate.offer({protocol::SkidDrive{.left_rad_s = 1.0}, {"left", {}}});
    gate.offer({protocol::SkidDrive{.right_rad_s = 2.0}, {"right", {}}});
    QCOMPARE(releasedSkid(gate), (protocol::SkidDrive{.left_rad_s = 1.0, .right_rad_s = 2.0}));
    gate.offer({protocol::SkidDrive{.left_rad_s = 100.0, .normalized = true}, {"per cent", {}}});
    gate.offer({protocol::SkidDrive{.right_rad_s = 2.0}, {"radians", {}}});
    QCOMPARE(releasedSkid(gate), (protocol::SkidDrive{.right_rad_s = 2.0}));
    gate.offer({protocol::AerialDrive{.climb_m_s = 1.0}, {"in the air", {}}});
    gate.offer({protocol::SkidDrive{.right_rad_s = 2.0}, {"on the ground", {}}});
    QCOMPARE(releasedSkid(gate), (protocol::SkidDrive{.right_rad_s = 2.0}));
}

void tst_DriveGate::neverMixesPercentWithMetres() {
    DriveGate gate;
    gate.offer(drive({.climb_m_s = 100.0, .normalized = true}));
    gate.offer(drive({.forward_m_s = 3.0}));
    QCOMPARE(released(gate.release(Seconds{1.0})), (protocol::AerialDrive{.forward_m_s = 3.0}));
}

void tst_DriveGate::opensForAClockThatRanBackward() {
    DriveGate gate;
    gate.offer(drive({.forward_m_s = 1.0}));
    QVERIFY(gate.release(Seconds{500.0}));
    gate.offer(drive({.forward_m_s = 2.0}));
    QVERIFY(gate.release(Seconds{0.2}));
}

void tst_DriveGate::canBeToldNotToWait() {
    DriveGate gate;
    gate.offer(drive({.forward_m_s = 1.0}));
    QVERIFY(gate.release(Seconds{1.0}));
    gate.offer(drive({.forward_m_s = 0.0}));
    QVERIFY(!gate.release(Seconds{1.0}));
    QVERIFY(gate.releaseNow(Seconds{1.0}));
    QVERIFY(!gate.releaseNow(Seconds{1.0}));
}

QTEST_APPLESS_MAIN(tst_DriveGate)
#include "tst_drive_gate.moc"
