// A mission that is killed in the middle, and what the program `usar-mission` makes of its rest.
#include <QDateTime>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include "core/link/recording_reader.h"
#include "core/mission/runs/recorded_scan.h"
#include "tests/suite/suite.h"

namespace tst_usar_continue {

using namespace usar;

namespace {

constexpr int patience_ms = 110000;
const QString program = USAR_BINARY_DIR "/bin/usar-mission";

struct Ended {
    int exit_code = -1;
    QByteArray err;
    QJsonObject summary;
};

Ended run(const QStringList& arguments) {
    QProcess process;
    process.start(program, arguments);
    if (!process.waitForFinished(patience_ms))
        process.kill();
    const QByteArray out = process.readAllStandardOutput();
    return {process.exitCode(), process.readAllStandardError(),
            QJsonDocument::fromJson(out.trimmed().split('\n').last()).object()};
}

/// Starts the program and kills it as soon as its progress bar is this long. Returns the moment before the kill;
/// invalid if the program ended by itself, and why is printed.
QDateTime killAt(const QByteArray& bar, const QStringList& arguments) {
    QProcess process;
    process.setReadChannel(QProcess::StandardError);
    process.start(program, arguments);
    QByteArray err;
    while (!err.contains(bar) && process.waitForReadyRead(patience_ms))
        err += process.readAllStandardError();
    const QDateTime moment = QDateTime::currentDateTimeUtc();
    process.kill(); // SIGKILL: nothing of the program runs any more.
    process.waitForFinished(patience_ms);
    if (err.contains(bar) && process.exitStatus() == QProcess::CrashExit)
        return moment;
    qWarning("It was not killed: %s%s", err.constData(), process.readAllStandardOutput().constData());
    return {};
}

} // namespace

class tst_UsarContinue : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void theRestIsFlownAndTheWholeIsKept();
    void whatIsCutOffTwiceIsContinuedTwice();
    void aWholeRecordingLeavesNothingToFly();
    void aKillCostsLessThanASecond();
    void refusalsNameTheFileAndTheMend_data();
    void refusalsNameTheFileAndTheMend();

private:
    QString path(const QString& name) const { return folder_.filePath(name); }
    QStringList flight(const QString& recording) const {
        return {"run",           path("mission.json"), "--seed",       "5", "--speed", "60", "--out",
                path("results"), "--record",           path(recording)};
    }

    QTemporaryDir folder_;
    double whole_pct_ = 0.0; ///< coverage of a run that nobody cuts off
    double whole_s_ = 0.0;   ///< its duration
};

void tst_UsarContinue::initTestCase() {
    QFile file(path("mission.json"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("{ \"name\": \"Cut off\", \"area\": { \"x\": -20, \"y\": -16, \"width\": 40, \"height\": 32 } }");
    file.close();
    const Ended ended =
        run({"run", path("mission.json"), "--seed", "5", "--out", path("whole"), "--record", path("whole.usarrec")});
    QVERIFY2(ended.exit_code == 0, ended.err);
    QVERIFY(ended.summary["continues"].isNull());
    whole_pct_ = ended.summary["coverage_pct"].toDouble();
    whole_s_ = ended.summary["duration_s"].toDouble();
    QVERIFY(whole_pct_ > 95.0);
}

void tst_UsarContinue::theRestIsFlownAndTheWholeIsKept() {
    QVERIFY(killAt("[##########", flight("half.usarrec")).isValid());
    QVERIFY(mission::brokeOffInMission(path("half.usarrec")));
    QVERIFY(!mission::brokeOffInMission(path("whole.usarrec")));
    const auto scan = mission::readRecordedScan(path("half.usarrec"));
    QVERIFY2(scan.has_value(), scan ? "" : scan.error().text().c_str());
    QVERIFY(!scan->finished && scan->flown.seed == 5u);
    const Rectangle whole{{-20, -16}, {20, 16}};
    QCOMPARE(scan->flown.mission.area_in_map, whole);
    QVERIFY(whole.contains(scan->rest_in_map));
    QVERIFY2(scan->rest_in_map.area_m2() < 0.8 * whole.area_m2(),
             qPrintable(QString::number(scan->rest_in_map.area_m2())));

    const Ended rest = run({"run", "--continue", path("half.usarrec"), "--out", path("rest")});
    QVERIFY2(rest.exit_code == 0, rest.err);
    QCOMPARE(rest.summary["seed"].toInt(), 5);
    QCOMPARE(rest.summary["mission"].toString(), QString("Cut off"));
    const QJsonObject before = rest.summary["continues"].toObject();
    QCOMPARE(before["recording"].toString(), path("half.usarrec"));
    QCOMPARE(before["cells"].toInt(), int(scan->scan.run.cells));
    QVERIFY(before["duration_s"].toDouble() > 0.2 * whole_s_);
    QVERIFY2(rest.summary["coverage_pct"].toDouble() > whole_pct_ - 1.0,
             QJsonDocument(rest.summary).toJson().constData());
    QVERIFY(rest.summary["duration_s"].toDouble() < 0.85 * whole_s_);
    QVERIFY(rest.summary["rmse_m"].toDouble() < 2.0);
    for (const QJsonValue name : rest.summary["files"].toArray())
        if (QFile json(name.toString()); name.toString().endsWith(".json") && json.open(QIODevice::ReadOnly)) {
            const QJsonObject saved = QJsonDocument::fromJson(json.readAll()).object();
            QCOMPARE(saved["map"].toObject()["area"].toObject()["width"].toDouble(), 40.0);
            QVERIFY(saved["continues"].isObject());
        }
}

void tst_UsarContinue::whatIsCutOffTwiceIsContinuedTwice() {
    QVERIFY(killAt("[######", flight("first.usarrec")).isValid());
    QVERIFY(killAt("[######", {"run", "--continue", path("first.usarrec"), "--speed", "60", "--out", path("results"),
                               "--record", path("second.usarrec")})
                .isValid());
    const auto first = mission::readRecordedScan(path("first.usarrec"));
    const auto second = mission::readRecordedScan(path("second.usarrec"));
    QVERIFY(first && second);
    QVERIFY(second->scan.run.cells > first->scan.run.cells);
    QVERIFY(second->scan.run.duration > first->scan.run.duration);
    QVERIFY(first->rest_in_map.contains(second->rest_in_map));
    const Ended rest = run({"run", "--continue", path("second.usarrec"), "--out", path("rest")});
    QVERIFY2(rest.exit_code == 0, rest.err);
    constexpr double gaps_pct = 3.2; // Each of the cuts may leave gaps of one percent of the area.
    QVERIFY2(rest.summary["coverage_pct"].toDouble() > whole_pct_ - gaps_pct,
             QJsonDocument(rest.summary).toJson().constData());
    QVERIFY(QFile::remove(path("first.usarrec")));
    const Ended without = run({"run", "--continue", path("second.usarrec"), "--out", path("rest")});
    QCOMPARE(without.exit_code, 2);
    QVERIFY2(without.err.contains("first.usarrec"), without.err);
}

void tst_UsarContinue::aWholeRecordingLeavesNothingToFly() {
    const Ended ended = run({"run", "--continue", path("whole.usarrec"), "--out", path("again")});
    QVERIFY2(ended.exit_code == 0, ended.err);
    QVERIFY(ended.summary["reason"].toString().startsWith("Nothing was left to fly"));
    QCOMPARE(ended.summary["duration_s"].toDouble(), 0.0);
    QCOMPARE(ended.summary["coverage_pct"].toDouble(), whole_pct_);
    QVERIFY(ended.summary["files"].toArray().size() >= 5);
}

void tst_UsarContinue::aKillCostsLessThanASecond() {
    const QDateTime killed = killAt("[###", flight("loss.usarrec"));
    QVERIFY(killed.isValid());
    const auto reader = link::RecordingReader::open(path("loss.usarrec"));
    QVERIFY(reader.has_value());
    const link::RecordingSurvey& survey = (*reader)->survey();
    QVERIFY(!survey.ended && !survey.being_written);
    const QDateTime began =
        QDateTime::fromString(QString::fromStdString(survey.facts.at("started")), Qt::ISODateWithMs);
    const double recorded_s = Seconds(survey.span).count();
    const double lived_s = double(began.msecsTo(killed)) / 1000.0;
    QVERIFY2(lived_s - recorded_s < 1.0, qPrintable(QString("%1 of %2 s").arg(recorded_s).arg(lived_s)));
}

void tst_UsarContinue::refusalsNameTheFileAndTheMend_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QByteArray>("words");
    QTest::newRow("no such file") << QStringList{"run", "--continue", path("none.usarrec")}
                                  << QByteArray("none.usarrec");
    QTest::newRow("no recording") << QStringList{"run", "--continue", path("mission.json")}
                                  << QByteArray("mission.json");
    QTest::newRow("a mission file besides")
        << QStringList{"run", path("mission.json"), "--continue", path("whole.usarrec")}
        << QByteArray("without a mission file");
}

void tst_UsarContinue::refusalsNameTheFileAndTheMend() {
    QFETCH(QStringList, arguments);
    QFETCH(QByteArray, words);
    const Ended ended = run(arguments);
    QCOMPARE(ended.exit_code, 2);
    QVERIFY2(ended.err.contains(words), ended.err);
}

USAR_TEST(tst_UsarContinue)

} // namespace tst_usar_continue

#include "tst_usar_continue.moc"
