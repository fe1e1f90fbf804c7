// The P2DX's missions that ship, run by the program for a minute each.
#include <cmath>

#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

namespace {

struct Ended {
    int exit_code = -1;
    QJsonObject summary;
    QByteArray said; ///< all of it
};

/// The mission that ships, for a minute.
Ended runForAMinute(const QString& name, const QStringList& options = {}) {
    QFile shipped(QString(USAR_SOURCE_DIR "/resources/missions/%1.json").arg(name));
    QTemporaryDir folder;
    QFile file(folder.filePath("minute.json"));
    if (!shipped.open(QIODevice::ReadOnly) || !file.open(QIODevice::WriteOnly))
        return {};
    QJsonObject mission = QJsonDocument::fromJson(shipped.readAll()).object();
    mission["parameters"] = QJsonObject{{"drive_time_s", 60}};
    file.write(QJsonDocument(mission).toJson());
    file.close();
    QProcess process;
    process.start(USAR_BINARY_DIR "/bin/usar-mission",
                  QStringList{"run", file.fileName(), "--seed", "2", "--out", folder.filePath("out")} + options);
    if (!process.waitForFinished(110000))
        process.kill();
    const QByteArray out = process.readAllStandardOutput();
    return {process.exitCode(), QJsonDocument::fromJson(out).object(), out + process.readAllStandardError()};
}

} // namespace

class tst_UsarP2dx : public QObject {
    Q_OBJECT
private slots:
    void drivesItsMissionsAndCountsWhatHappened_data();
    void drivesItsMissionsAndCountsWhatHappened();
    void standsWhileItsScannerIsSilent();
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
    const Ended ended = runForAMinute(QTest::currentDataTag());
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
    const Ended ended = runForAMinute("p2dx_room_posh", fault);
    QVERIFY2(ended.exit_code == 0, ended.said);
    QVERIFY2(ended.summary["longest_stay_s"].toDouble() > 17.0,
             ended.said); // it stops when the scan is two seconds old
    QVERIFY2(ended.said.contains("The range scanner is silent"), ended.said);
    QCOMPARE(ended.summary["collisions"].toInt(-1), 0);
}

QTEST_APPLESS_MAIN(tst_UsarP2dx)
#include "tst_usar_p2dx.moc"
