// `usar-mission plan-report` as a program, on a run that it has recorded itself.
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include "tests/suite/suite.h"

namespace tst_usar_plan_report {

namespace {

struct Ended {
    int exit_code = -1;
    QByteArray out;
    QByteArray err;
};

Ended run(const QStringList& arguments) {
    QProcess process;
    process.start(USAR_BINARY_DIR "/bin/usar-mission", arguments);
    if (!process.waitForFinished(110000))
        process.kill();
    return {process.exitCode(), process.readAllStandardOutput(), process.readAllStandardError()};
}

constexpr const char* drive = R"({ "name": "Short drive", "world": "vmac_room", "robot": "USARBot.P2DX",
    "behavior": "p2dx/posh", "area": { "x": -19, "y": -12, "width": 38, "height": 24 },
    "parameters": { "drive_time_s": %1 } })";

} // namespace

class tst_UsarPlanReport : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void tellsAPersonWhatNeverHappenedAndWhereTheTimeWent();
    void tellsAMachineTheSame();
    void addsUpTheRunsOfAPlan();
    void aFileCutOffIsReportedAndSaysSo();
    void refusalsNameTheFileAndTheMend_data();
    void refusalsNameTheFileAndTheMend();

private:
    QString path(const char* name) const { return folder_.filePath(name); }
    void drivePlan(const QString& behavior, const char* recording, int drive_time_s = 20);

    QTemporaryDir folder_;
};

void tst_UsarPlanReport::drivePlan(const QString& behavior, const char* recording, int drive_time_s) {
    QFile file(path("drive.json"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(QString(drive).arg(drive_time_s).toUtf8());
    file.close();
    const Ended ended =
        run({"run", path("drive.json"), "--behavior", behavior, "--out", path("out"), "--record", path(recording)});
    QVERIFY2(ended.exit_code == 0, ended.err);
}

void tst_UsarPlanReport::initTestCase() {
    drivePlan("p2dx/posh", "plan.usarrec");
    drivePlan("p2dx/cpp", "coded.usarrec");
}

void tst_UsarPlanReport::tellsAPersonWhatNeverHappenedAndWhereTheTimeWent() {
    const Ended ended = run({"plan-report", path("plan.usarrec")});
    QVERIFY2(ended.exit_code == 0, ended.err);
    const QString text = QString::fromUtf8(ended.out);
    QVERIFY2(text.startsWith("P2DX: 1 run, "), ended.out);
    QVERIFY2(text.contains("never-selected: P2DX ▸ fallback never started"), ended.out);
    QVERIFY2(text.contains("P2DX ▸ waiting ▸ Halt\n"), ended.out); // three seconds at the start
}

void tst_UsarPlanReport::tellsAMachineTheSame() {
    const Ended ended = run({"plan-report", "--json", path("plan.usarrec")});
    QVERIFY2(ended.exit_code == 0, ended.err);
    bool found = false;
    double time_s = 0.0;
    for (const QByteArray& line : ended.out.trimmed().split('\n')) {
        const QJsonObject object = QJsonDocument::fromJson(line).object();
        QVERIFY2(object["plan"].toString() == "P2DX", line);
        found = found ||
                (object["remark"].toString() == "never-selected" && object["name"].toString() == "P2DX ▸ fallback");
        time_s += object["type"].toString() == "drive" ? object["time_s"].toDouble() : 0.0;
    }
    QVERIFY2(found, ended.out);
    QVERIFY2(time_s > 19.0 && time_s < 21.0, ended.out);
}

void tst_UsarPlanReport::addsUpTheRunsOfAPlan() {
    const Ended ended = run({"plan-report", path("plan.usarrec"), path("plan.usarrec")});
    QVERIFY2(ended.exit_code == 0 && ended.out.startsWith("P2DX: 2 runs, "), ended.out + ended.err);
}

void tst_UsarPlanReport::aFileCutOffIsReportedAndSaysSo() {
    drivePlan("p2dx/posh", "long.usarrec",
              100); // A short one is one block on a fast machine, and half of it is nothing.
    QFile whole(path("long.usarrec"));
    QVERIFY(whole.open(QIODevice::ReadOnly));
    QFile cut(path("cut.usarrec"));
    QVERIFY(cut.open(QIODevice::WriteOnly));
    cut.write(whole.read(whole.size() / 2));
    cut.close();
    const Ended ended = run({"plan-report", path("cut.usarrec")});
    QCOMPARE(ended.exit_code, 0);
    QVERIFY2(ended.out.startsWith("P2DX: 1 run, "), ended.out);
    QVERIFY2(ended.err.contains("cut.usarrec") && ended.err.contains("incomplete"), ended.err);
}

void tst_UsarPlanReport::refusalsNameTheFileAndTheMend_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QByteArray>("words");
    QTest::newRow("no file") << QStringList{} << QByteArray("Write usar-mission plan-report");
    QTest::newRow("an option that is none")
        << QStringList{"--jsn", path("plan.usarrec")} << QByteArray("Write usar-mission plan-report");
    QTest::newRow("no such file") << QStringList{path("none")} << QByteArray("none: ");
    QTest::newRow("no recording") << QStringList{path("drive.json")} << QByteArray("drive.json: byte 0");
    QTest::newRow("no plan in it") << QStringList{path("coded.usarrec")}
                                   << QByteArray("coded.usarrec: no plan ran in this recording");
    QTest::newRow("one of two") << QStringList{path("none"), path("plan.usarrec")} << QByteArray("Check the name");
}

void tst_UsarPlanReport::refusalsNameTheFileAndTheMend() {
    QFETCH(QStringList, arguments);
    QFETCH(QByteArray, words);
    const Ended ended = run(QStringList{"plan-report"} + arguments);
    QCOMPARE(ended.exit_code, 2);
    QVERIFY2(ended.err.contains(words), ended.err);
    QCOMPARE(ended.out.isEmpty(), arguments.size() < 2 || arguments.front().startsWith("--"));
}

USAR_TEST(tst_UsarPlanReport)

} // namespace tst_usar_plan_report

#include "tst_usar_plan_report.moc"
