// A flight of the program `usar-mission`, recorded, replayed and converted by the same program.
#include <QFile>
#include <QFileInfo>
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
    void aRunWithALimitWritesParts();
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

/// The flight is long enough for a second part, and short enough for nothing to be deleted.
void tst_UsarReplay::aRunWithALimitWritesParts() {
    QFile mission(path("small.json"));
    QVERIFY(mission.open(QIODevice::ReadOnly));
    QJsonObject wide = QJsonDocument::fromJson(mission.readAll()).object();
    wide["area"] = QJsonObject{{"x", -40}, {"y", -40}, {"width", 80}, {"height", 80}};
    QFile file(path("wide.json"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(QJsonDocument(wide).toJson());
    file.close();
    const Ended flown =
        run({"run", file.fileName(), "--out", path("out"), "--record", path("p.usarrec"), "--record-limit", "10"});
    QVERIFY2(flown.exit_code == 0, flown.err);
    QVERIFY2(QFile::exists(path("p.part1.usarrec")), qPrintable(QString::number(QFileInfo(path("p.usarrec")).size())));
    const Ended whole = run({"replay", path("p.usarrec")});
    QVERIFY2(whole.exit_code == 0, whole.err);
    QVERIFY(whole.summary["ended_in_order"].toBool());
    QVERIFY(whole.summary["lines_in"].toInt() >= flown.summary["lines_received"].toInt());
    QCOMPARE(whole.summary["last_line"].toInt(), whole.summary["lines_in"].toInt());

    QVERIFY(QFile::rename(path("p.part1.usarrec"), path("elsewhere.usarrec")));
    const Ended late = run({"replay", path("p.usarrec")});
    QVERIFY2(late.exit_code == 0, late.err);
    QVERIFY2(late.err.contains("missing, because p.part"), late.err);
    QVERIFY(late.summary["lines_in"].toInt() < whole.summary["lines_in"].toInt());
    const Ended exported = run({"recording-to-mcap", path("p.usarrec"), path("p.mcap")});
    QVERIFY2(exported.exit_code == 0 && exported.err.contains("missing, because p.part"), exported.err);
    const Ended map = run({"export", path("p.usarrec"), "--formats", "asc", "--out", path("maps")});
    QVERIFY2(map.exit_code == 0 && map.err.contains("The map lacks what was scanned there."), map.err);
    const Ended rest = run({"run", "--continue", path("p.usarrec"), "--out", path("rest")});
    QVERIFY2(rest.err.contains("What was scanned there is flown again."), rest.err);
    QVERIFY2(rest.exit_code == 0, rest.err);

    QVERIFY(QFile::rename(path("elsewhere.usarrec"), path("p.part1.usarrec")));
    QVERIFY(QFile::resize(path("p.usarrec"), 0)); // As a loss of power leaves it.
    const Ended left = run({"replay", path("p.usarrec")});
    QVERIFY2(left.exit_code == 1 && left.err.contains("nothing can be read in p.usarrec"), left.err);
    QVERIFY(left.summary["lines_in"].toInt() > 1000 && !left.summary["success"].toBool());
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
