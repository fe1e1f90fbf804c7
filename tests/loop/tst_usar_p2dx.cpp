// The P2DX's missions that ship, run by the program for a minute each.
#include <cmath>

#include "tests/loop/shipped_mission.h"
#include "tests/suite/suite.h"

namespace tst_usar_p2dx {

using namespace usar::test;

namespace {

EndedMission runForAMinute(const QString& name, const QStringList& options = {}) {
    return runShipped(name, {{"drive_time_s", 60}}, options);
}

} // namespace

class tst_UsarP2dx : public QObject {
    Q_OBJECT
private slots:
    void drivesItsMissionsAndCountsWhatHappened_data();
    void drivesItsMissionsAndCountsWhatHappened();
    void standsWhileItsScannerIsSilent();
    void standsWhileItsScannerIsFrozen();
};

void tst_UsarP2dx::drivesItsMissionsAndCountsWhatHappened_data() {
    QTest::addColumn<QString>("behavior");
    QTest::newRow("p2dx_room") << "p2dx/cpp";
    QTest::newRow("p2dx_room_posh") << "p2dx/posh";
    QTest::newRow("p2dx_meadow") << "p2dx/cpp";
    QTest::newRow("p2dx_meadow_posh") << "p2dx/posh";
}

void tst_UsarP2dx::drivesItsMissionsAndCountsWhatHappened() {
    QFETCH(QString, behavior);
    const EndedMission ended = runForAMinute(QTest::currentDataTag());
    QVERIFY2(ended.exit_code == 0, ended.said);
    QCOMPARE(ended.summary["behavior"].toString(), behavior);
    QVERIFY2(ended.summary["reason"].toString().startsWith("Drove for 60 s"), ended.said);
    QCOMPARE(ended.summary["collisions"].toInt(-1), 0);
    const double stay_s = ended.summary["longest_stay_s"].toDouble(-1.0);
    QVERIFY2(stay_s > 3.0 && stay_s < 60.0, ended.said);
    const double true_m = ended.summary["true_distance_m"].toDouble();
    QVERIFY2(true_m > 5.0 && std::abs(true_m - ended.summary["distance_m"].toDouble()) < 0.2 * true_m, ended.said);
}

void tst_UsarP2dx::standsWhileItsScannerIsSilent() {
    const QStringList fault{"--fault", "sensor_dropout robot=R1 sensor=Scanner1 from=20 for=20"};
    const EndedMission ended = runForAMinute("p2dx_room_posh", fault);
    QVERIFY2(ended.exit_code == 0, ended.said);
    QVERIFY2(ended.summary["longest_stay_s"].toDouble() > 17.0,
             ended.said); // it stops when the scan is two seconds old
    QVERIFY2(ended.said.contains("The range scanner is silent"), ended.said);
    QCOMPARE(ended.summary["collisions"].toInt(-1), 0);
}

void tst_UsarP2dx::standsWhileItsScannerIsFrozen() {
    const QStringList fault{"--fault", "sensor_freeze robot=R1 sensor=Scanner1 from=20 for=20"};
    const EndedMission ended = runForAMinute("p2dx_room", fault);
    QVERIFY2(ended.exit_code == 0, ended.said);
    QVERIFY2(ended.summary["longest_stay_s"].toDouble() > 18.0, ended.said); // it stops at once
    QVERIFY2(ended.said.contains("The range scanner is frozen"), ended.said);
    QCOMPARE(ended.summary["collisions"].toInt(-1), 0);
}

USAR_TEST(tst_UsarP2dx)

} // namespace tst_usar_p2dx

#include "tst_usar_p2dx.moc"
