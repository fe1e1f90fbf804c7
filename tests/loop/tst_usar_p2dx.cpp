// The P2DX's missions that ship, run by the program for a minute each.
#include <cmath>

#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

class tst_UsarP2dx : public QObject {
    Q_OBJECT
private slots:
    void drivesItsMissionsAndCountsWhatHappened_data();
    void drivesItsMissionsAndCountsWhatHappened();
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
    QFile shipped(QString(USAR_SOURCE_DIR "/resources/missions/%1.json").arg(QTest::currentDataTag()));
    QVERIFY(shipped.open(QIODevice::ReadOnly));
    QJsonObject mission = QJsonDocument::fromJson(shipped.readAll()).object();
    QCOMPARE(mission["behavior"].toString(), behavior);
    mission["parameters"] = QJsonObject{{"drive_time_s", 60}};
    QTemporaryDir folder;
    QFile file(folder.filePath("minute.json"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(QJsonDocument(mission).toJson());
    file.close();
    QProcess process;
    process.start(USAR_BINARY_DIR "/bin/usar-mission",
                  {"run", file.fileName(), "--seed", "2", "--out", folder.filePath("out")});
    QVERIFY(process.waitForFinished(110000));
    const QByteArray out = process.readAllStandardOutput();
    QVERIFY2(process.exitCode() == 0, out + process.readAllStandardError());
    const QJsonObject summary = QJsonDocument::fromJson(out).object();
    QVERIFY2(summary["reason"].toString().startsWith("Drove for 60 s"), out);
    QCOMPARE(summary["collisions"].toInt(-1), 0);
    const double stay_s = summary["longest_stay_s"].toDouble(-1.0);
    QVERIFY2(stay_s > 3.0 && stay_s < 60.0, out);
    const double true_m = summary["true_distance_m"].toDouble();
    QVERIFY2(true_m > 5.0 && std::abs(true_m - summary["distance_m"].toDouble()) < 0.2 * true_m, out);
}

QTEST_APPLESS_MAIN(tst_UsarP2dx)
#include "tst_usar_p2dx.moc"
