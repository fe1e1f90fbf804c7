// A flight of the program `usar-mission`, recorded, replayed and converted by the same program.
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include "tests/suite/suite.h"

namespace tst_usar_replay {

namespace {

struct Ended {
    int exit_code = -1;
    QByteArray out;
    QByteArray err;
    QJsonObject summary;
};

Ended run(const QStringList& arguments) {
    QProcess process;
    process.start(USAR_BINARY_DIR "/bin/usar-mission", arguments);
    process.waitForFinished(110000);
    Ended ended{process.exitCode(), process.readAllStandardOutput(), process.readAllStandardError(), {}};
    ended.summary = QJsonDocument::fromJson(ended.out.trimmed().split('\n').last()).object();
    return ended;
}

QByteArray bytesOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace

class tst_UsarReplay : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void theReplayHasEveryLineOfTheFlight();
    void aPartOfItCanBePlayed();
    void textAndBackIsTheSameText();
    void aFileCutOffIsPlayedAndSaysWhatIsLost();
    void refusalsNameTheFileAndTheMend_data();
    void refusalsNameTheFileAndTheMend();

private:
    QString path(const char* name) const { return folder_.filePath(name); }

    QTemporaryDir folder_;
    QJsonObject flight_;
};

void tst_UsarReplay::initTestCase() {
    QFile mission(USAR_SOURCE_DIR "/resources/missions/quick_scan.json");
    QVERIFY(mission.open(QIODevice::ReadOnly));
    QJsonObject small = QJsonDocument::fromJson(mission.readAll()).object();
    small["area"] = QJsonObject{{"x", -8}, {"y", -8}, {"width", 16}, {"height", 16}};
    QFile file(path("small.json"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(QJsonDocument(small).toJson());
    file.close();
    const Ended ended = run({"run", path("small.json"), "--out", path("out"), "--record", path("r.usarrec")});
    QVERIFY2(ended.exit_code == 0, ended.err);
    flight_ = ended.summary;
}

void tst_UsarReplay::theReplayHasEveryLineOfTheFlight() {
    const Ended ended = run({"replay", path("r.usarrec")});
    QVERIFY2(ended.exit_code == 0, ended.err);
    QVERIFY(ended.summary["success"].toBool() && ended.summary["ended_in_order"].toBool());
    QVERIFY(ended.summary["lines_in"].toInt() >= flight_["lines_received"].toInt());
    QCOMPARE(ended.summary["last_line"].toInt(), ended.summary["lines_in"].toInt());
    QCOMPARE(ended.summary["diagnostics"].toInt(), 0);
    const QJsonObject types = ended.summary["types"].toObject();
    QVERIFY(types["SEN RangeScanner"].toInt() > 100 && types["STA AerialVehicle"].toInt() > 100);
    QVERIFY(ended.summary["sources"].toObject().contains("session: spawn"));
    QCOMPARE(ended.summary["facts"].toObject()["robot"].toString(), QString("R1"));
    QVERIFY(ended.summary["span_s"].toDouble() >= flight_["duration_s"].toDouble());
}

void tst_UsarReplay::aPartOfItCanBePlayed() {
    const Ended ended = run({"replay", path("r.usarrec"), "--from", "10", "--to", "20", "--speed", "50"});
    QVERIFY2(ended.exit_code == 0, ended.err);
    const int states = ended.summary["types"].toObject()["STA AerialVehicle"].toInt();
    QVERIFY2(states >= 49 && states <= 51, ended.out); // five a second
    QVERIFY(ended.summary["first_line"].toInt() > 100);
    QCOMPARE(ended.summary["to_s"].toDouble(), 20.0);
}

void tst_UsarReplay::textAndBackIsTheSameText() {
    const Ended to_text = run({"recording-to-text", path("r.usarrec"), path("r.txt")});
    QVERIFY2(to_text.exit_code == 0, to_text.err);
    QVERIFY(bytesOf(path("r.txt")).contains("\"session: spawn\" \"INIT {ClassName"));
    QVERIFY(run({"text-to-recording", path("r.txt"), path("again.usarrec")}).exit_code == 0);
    for (const char* const recording : {"r.usarrec", "again.usarrec"})
        QVERIFY(run({"recording-to-text", path(recording), "-"}).out == bytesOf(path("r.txt")));
}

void tst_UsarReplay::aFileCutOffIsPlayedAndSaysWhatIsLost() {
    QFile cut(path("cut.usarrec"));
    QVERIFY(cut.open(QIODevice::WriteOnly));
    cut.write(bytesOf(path("r.usarrec")).left(100000));
    cut.close();
    const Ended ended = run({"replay", cut.fileName()});
    QVERIFY2(ended.exit_code == 1, ended.err);
    QVERIFY(ended.summary["tail_lost_bytes"].toInt() > 0);
    QVERIFY(!ended.summary["ended_in_order"].toBool());
    QVERIFY(ended.summary["lines_in"].toInt() > 10);
    QVERIFY2(ended.err.contains("cut.usarrec") && ended.err.contains("incomplete"), ended.err);
}

void tst_UsarReplay::refusalsNameTheFileAndTheMend_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QByteArray>("words");
    QTest::newRow("no such file") << QStringList{"replay", path("none")} << QByteArray("Check the name");
    QTest::newRow("no recording") << QStringList{"replay", path("small.json")} << QByteArray("small.json: byte 0");
    QTest::newRow("no text form") << QStringList{"text-to-recording", path("small.json"), path("x")}
                                  << QByteArray("small.json, line 1");
    QTest::newRow("over a file") << QStringList{"recording-to-text", path("r.usarrec"), path("small.json")}
                                 << QByteArray("left alone");
    QTest::newRow("recording over a file")
        << QStringList{"run", path("small.json"), "--record", path("small.json")} << QByteArray("left alone");
}

void tst_UsarReplay::refusalsNameTheFileAndTheMend() {
    QFETCH(QStringList, arguments);
    QFETCH(QByteArray, words);
    const Ended ended = run(arguments);
    QVERIFY2(ended.exit_code == 2, ended.out);
    QVERIFY2(ended.err.contains(words), ended.err);
    QCOMPARE(ended.err.count(words), 1);
    QVERIFY(!QFile::exists(path("x")));
}

USAR_TEST(tst_UsarReplay)

} // namespace tst_usar_replay

#include "tst_usar_replay.moc"
