#include <csignal>

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include "core/campaign/runs/run_request.h"
#include "tests/suite/signaling.h"
#include "tests/suite/suite.h"

namespace tst_usar_mission {

/// The program itself: what it prints, what it leaves, how it exits.
class tst_UsarMission : public QObject {
    Q_OBJECT
private slots:
    void init();
    void cleanup();

    void fliesAMissionToItsEnd();
    void equalSeedsGiveEqualMaps();
    void copiesOfAWorkerFlyAsNewProcessesDo();
    void onlyTheRunsThatAreToDoSoLeaveFiles_data();
    void onlyTheRunsThatAreToDoSoLeaveFiles();
    void faultsComeWithTheMissionAndAreToldInItsResults();
    void aVanishedRobotIsToldAtOnce();
    void rejectsTheRestAndSaysWhere_data();
    void rejectsTheRestAndSaysWhere();
    void aRefusalTellsWhatIsKnown_data();
    void aRefusalTellsWhatIsKnown();
    void aProgramWithoutItsFilesSaysWhatIsMissing_data();
    void aProgramWithoutItsFilesSaysWhatIsMissing();
    void helpGoesToStandardOutput();
    void ctrlCKeepsWhatWasScanned_data();
    void ctrlCKeepsWhatWasScanned();

private:
    struct Ended {
        int exit_code = -1;
        QJsonObject summary; ///< last line of standard output
        QByteArray out;
        QByteArray err;
    };
    static Ended read(QProcess& process);
    static Ended run(const QStringList& arguments);
    /// Those of `run` for a small mission.
    QStringList argumentsFor(const QString& seed) const;
    /// Writes a mission and gives its path.
    QString missionFile(const QByteArray& json) const;

    std::unique_ptr<QTemporaryDir> folder_;
};

namespace {

const QString program = QString(USAR_BINARY_DIR) + "/bin/usar-mission";
constexpr int patience_ms = 100000;

const QByteArray small = R"({ "name": "Small", "area": { "x": -8, "y": -6, "width": 16, "height": 12 } })";

constexpr const char* promised_keys[] = {
    "success",       "reason",         "duration_s",      "distance_m",      "charges",  "cells",
    "coverage_pct",  "rmse_m",         "collisions",      "mission",         "behavior", "lines_received",
    "seed",          "files",          "true_distance_m", "longest_stay_s",  "falls",    "touches",
    "first_touch_s", "least_height_m", "mean_height_m",   "height_spread_m", "cpu_s"};

/// The bytes of the map that a run has written.
QByteArray heightsOf(const QJsonObject& summary) {
    for (const QJsonValue name : summary["files"].toArray())
        if (QFile file(name.toString()); name.toString().endsWith(".bil") && file.open(QIODevice::ReadOnly))
            return file.readAll();
    return {};
}

} // namespace

void tst_UsarMission::init() {
    folder_ = std::make_unique<QTemporaryDir>();
}

void tst_UsarMission::cleanup() {
    folder_.reset();
}

QString tst_UsarMission::missionFile(const QByteArray& json) const {
    QFile file(folder_->filePath("mission.json"));
    if (file.open(QIODevice::WriteOnly))
        file.write(json);
    return file.fileName();
}

tst_UsarMission::Ended tst_UsarMission::read(QProcess& process) {
    Ended ended;
    if (!process.waitForFinished(patience_ms))
        process.kill();
    ended.exit_code = process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1;
    ended.out = process.readAllStandardOutput();
    ended.err = process.readAllStandardError();
    ended.summary = QJsonDocument::fromJson(ended.out.trimmed().split('\n').last()).object();
    return ended;
}

tst_UsarMission::Ended tst_UsarMission::run(const QStringList& arguments) {
    QProcess process;
    process.start(program, arguments);
    return read(process);
}

QStringList tst_UsarMission::argumentsFor(const QString& seed) const {
    return {"run", missionFile(small), "--seed", seed, "--out", folder_->filePath("results")};
}

void tst_UsarMission::fliesAMissionToItsEnd() {
    const QString out = folder_->filePath("results");
    const Ended ended = run({"run", missionFile(small), "--seed", "4", "--out", out});
    QVERIFY2(ended.exit_code == 0, ended.out + ended.err);
    QCOMPARE(ended.summary["success"].toBool(), true);
    QCOMPARE(ended.summary["seed"].toInt(), 4);
    QCOMPARE(ended.summary["collisions"].toInt(-1), 0);
    QVERIFY(ended.summary["coverage_pct"].toDouble() > 90.0);
    QVERIFY(ended.summary["rmse_m"].isDouble());
    QVERIFY(ended.summary["speed_x"].toDouble() > 1.0);
    for (const QJsonValue file : ended.summary["files"].toArray())
        QVERIFY2(file.toString().startsWith(out) && QFile::exists(file.toString()), qPrintable(file.toString()));
    QVERIFY2(ended.err.contains("ETA"), ended.err); // the progress bar
    QCOMPARE(ended.out.count('\n'), 1);
}

void tst_UsarMission::equalSeedsGiveEqualMaps() {
    const auto mapOf = [&](const QString& seed, const QStringList& further = {}) {
        return heightsOf(run(argumentsFor(seed) + further).summary);
    };
    const QByteArray first = mapOf("9");
    QVERIFY(!first.isEmpty());
    QVERIFY(first == mapOf("9"));
    QVERIFY2(first == mapOf("9", {"--one-thread"}), "simulator, mission and behavior in one thread");
    QVERIFY2(first == mapOf("9", {"--speed", "500"}), "each in a thread of its own");
    QVERIFY(first != mapOf("10"));
}

void tst_UsarMission::copiesOfAWorkerFlyAsNewProcessesDo() {
    QProcess worker;
    worker.start(program, {usar::campaign::worker_verb});
    const QStringList one_thread{"--one-thread"};
    int number = 0;
    for (const QStringList& arguments : {argumentsFor("9") + one_thread, argumentsFor("10") + one_thread,
                                         argumentsFor("9") + one_thread, QStringList{"run", "gone.json"}})
        worker.write(usar::campaign::write(usar::campaign::RunRequest{++number, arguments}));
    worker.closeWriteChannel();
    const Ended ended = read(worker);
    QCOMPARE(ended.exit_code, 0);
    std::vector<QJsonObject> summaries;
    QByteArrayList ends;
    for (const QByteArray& line : ended.out.split('\n')) {
        if (line.startsWith('{'))
            summaries.push_back(QJsonDocument::fromJson(line).object());
        else if (!line.isEmpty())
            ends << line;
    }
    QCOMPARE(ends, (QByteArrayList{"ended 1 0", "ended 2 0", "ended 3 0", "ended 4 2"}));
    QCOMPARE(summaries.size(), std::size_t(4));
    const QByteArray alone = heightsOf(run(argumentsFor("9")).summary);
    QVERIFY(!alone.isEmpty());
    QVERIFY(heightsOf(summaries[0]) == alone);
    QVERIFY(heightsOf(summaries[1]) != alone);
    QVERIFY(heightsOf(summaries[2]) == alone);
    QVERIFY(summaries[3]["reason"].toString().contains("gone.json"));
}

void tst_UsarMission::onlyTheRunsThatAreToDoSoLeaveFiles_data() {
    QTest::addColumn<QString>("which");
    QTest::addColumn<bool>("fails");
    QTest::addColumn<bool>("left");
    QTest::newRow("a success, if failed") << "failed" << false << false;
    QTest::newRow("a failure, if failed") << "failed" << true << true;
    QTest::newRow("a failure, never") << "never" << true << false;
}
void tst_UsarMission::onlyTheRunsThatAreToDoSoLeaveFiles() {
    QFETCH(QString, which);
    QFETCH(bool, fails);
    QFETCH(bool, left);
    const QStringList fault = fails ? QStringList{"--fault", "vanish robot=R1 after=40"} : QStringList{};
    const Ended ended = run(argumentsFor("9") + QStringList{"--files", which} + fault);
    QVERIFY2(ended.exit_code == (fails ? 1 : 0), ended.out + ended.err);
    QVERIFY(ended.summary["cells"].toInt() > 100);
    QCOMPARE(!ended.summary["files"].toArray().empty(), left);
    QCOMPARE(!QDir(folder_->filePath("results")).isEmpty(), left);
}

void tst_UsarMission::faultsComeWithTheMissionAndAreToldInItsResults() {
    QByteArray with_wind = small;
    with_wind.replace("\"area\"", "\"faults\": [\"wind speed=1.5 toward_deg=90 gust=0.3 from=5\"], \"area\"");
    const Ended ended = run(
        {"run", missionFile(with_wind), "--fault", "battery robot=R1 from=20", "--out", folder_->filePath("results")});
    QVERIFY2(ended.exit_code == 1, ended.out + ended.err); // no robot scans with an empty battery
    const QJsonArray faults = ended.summary["faults"].toArray();
    QCOMPARE(faults.size(), 2);
    QCOMPARE(faults.at(0).toString().section(": ", 1), "fault begins: wind speed=1.5 toward_deg=90 gust=0.3 from=5");
    QCOMPARE(faults.at(1).toString().section(": ", 1), "fault begins: battery robot=R1 from=20");
    QVERIFY2(ended.err.contains("fault begins: battery"), ended.err);
    const Ended cut = run({"run", missionFile(small), "--fault", "link_cut from=5", "--out", folder_->filePath("cut")});
    QVERIFY2(cut.exit_code == 1, cut.out + cut.err);
    QCOMPARE(cut.summary["faults"].toArray().at(0).toString(), "5.0 s: fault begins: link_cut from=5");
}

void tst_UsarMission::aVanishedRobotIsToldAtOnce() {
    const Ended ended =
        run({"run", missionFile(small), "--fault", "vanish robot=R1 after=40", "--out", folder_->filePath("results")});
    QVERIFY2(ended.exit_code == 1, ended.out + ended.err);
    QVERIFY2(ended.summary["reason"].toString().startsWith("The simulator has removed the robot R1"), ended.out);
    const double duration_s = ended.summary["duration_s"].toDouble();
    QVERIFY2(duration_s > 35.0 && duration_s < 41.0, ended.out);
    QVERIFY(!ended.summary["files"].toArray().empty()); // what was scanned is kept
}

void tst_UsarMission::rejectsTheRestAndSaysWhere_data() {
    QTest::addColumn<QByteArray>("mission");
    QTest::addColumn<QStringList>("options");
    QTest::addColumn<QString>("words");
    QTest::newRow("broken mission file") << QByteArray("{\n  \"name\": \"x\",\n  oops }") << QStringList{} << "3:";
    QTest::newRow("area without size") << QByteArray(
                                              R"({ "name": "x", "area": { "x": 0, "y": 0, "width": 0, "height": 5 } })")
                                       << QStringList{} << "area";
    QTest::newRow("area outside the world")
        << QByteArray(R"({ "name": "x", "area": { "x": 190, "y": 0, "width": 400, "height": 5 } })") << QStringList{}
        << "mission.json:1:24: area: the mission area (x 190.0..590.0 m, y 0.0..5.0 m) is entirely outside the world";
    QTest::newRow("unknown world")
        << QByteArray(R"({ "name": "x", "world": "moon", "area": { "x": 0, "y": 0, "width": 5, "height": 5 } })")
        << QStringList{} << "mission.json:1:25: world moon: there is no such world. Known in ";
    QTest::newRow("unknown start pose")
        << QByteArray(R"({ "name": "x", "start": "Roof", "area": { "x": 0, "y": 0, "width": 5, "height": 5 } })")
        << QStringList{} << "mission.json:1:25: Roof: the server knows no start pose with this name";
    QTest::newRow("unknown behavior") << small << QStringList{"--behavior", "airrobot/dance"} << "airrobot/dance";
    QTest::newRow("unknown parameter")
        << QByteArray("{ \"name\": \"x\", \"area\": { \"x\": 0, \"y\": 0, \"width\": 5, \"height\": 5 },\n"
                      "  \"parameters\": { \"scan_altitud_m\": 5 } }")
        << QStringList{} << "mission.json:2:19: parameter scan_altitud_m: there is no such parameter. Did you mean ";
    QTest::newRow("unwritable folder") << small << QStringList{"--out", "/proc/nowhere"} << "/proc/nowhere";
    QTest::newRow("wrong fault in the file")
        << QByteArray("{ \"name\": \"x\", \"area\": { \"x\": 0, \"y\": 0, \"width\": 5, \"height\": 5 },\n"
                      "  \"faults\": [\"wind sped=5\"] }")
        << QStringList{} << "mission.json:2:13: fault \"wind sped=5\": unknown word 'sped'. Did you mean 'speed'?";
    QTest::newRow("wrong fault") << small << QStringList{"--fault", "earthquake"} << "unknown kind 'earthquake'";
    QTest::newRow("faults of a real server") << small << QStringList{"--fault", "wind", "--connect", "127.0.0.1:9"}
                                             << "faults are possible only in the embedded simulator";
    QTest::newRow("wrong option") << small << QStringList{"--sped", "3"} << "--sped";
    QTest::newRow("dead host") << small << QStringList{"--connect", "127.0.0.1:9"} << "Nothing listens at 127.0.0.1:9";
}

void tst_UsarMission::rejectsTheRestAndSaysWhere() {
    QFETCH(QByteArray, mission);
    QFETCH(QStringList, options);
    QFETCH(QString, words);
    const Ended ended = run(QStringList{"run", missionFile(mission)} + options);
    QVERIFY2(ended.exit_code == 2, ended.out + ended.err);
    QCOMPARE(ended.summary["success"].toBool(true), false);
    QVERIFY2(ended.summary["reason"].toString().contains(words), ended.out);
    QVERIFY2(ended.err.contains(words.toUtf8()), ended.err);
    for (const char* key : promised_keys)
        QVERIFY2(ended.summary.contains(key), key);
}

void tst_UsarMission::aRefusalTellsWhatIsKnown_data() {
    QTest::addColumn<QByteArray>("mission");
    QTest::addColumn<QStringList>("options");
    QTest::addColumn<QJsonValue>("behavior");
    QTest::addColumn<QJsonValue>("seed");
    const QJsonValue unknown = QJsonValue::Null;
    QTest::newRow("options that cannot be read")
        << small << QStringList{"--seed", "5", "--sped", "3"} << unknown << unknown;
    QTest::newRow("a mission that cannot be read")
        << QByteArray("{") << QStringList{"--seed", "5"} << unknown << QJsonValue(5);
    QTest::newRow("the same with a behavior") << QByteArray("{") << QStringList{"--behavior", "airrobot/dance"}
                                              << QJsonValue("airrobot/dance") << QJsonValue(1);
    QTest::newRow("an unknown world")
        << QByteArray(R"({ "name": "x", "world": "moon", "area": { "x": 0, "y": 0, "width": 5, "height": 5 } })")
        << QStringList{} << QJsonValue("airrobot/cpp") << QJsonValue(1);
    QTest::newRow("an unknown behavior") << small << QStringList{"--behavior", "airrobot/dance"}
                                         << QJsonValue("airrobot/dance") << QJsonValue(1);
}

void tst_UsarMission::aRefusalTellsWhatIsKnown() {
    QFETCH(QByteArray, mission);
    QFETCH(QStringList, options);
    QFETCH(QJsonValue, behavior);
    QFETCH(QJsonValue, seed);
    const Ended ended = run(QStringList{"run", missionFile(mission)} + options);
    QCOMPARE(ended.exit_code, 2);
    QCOMPARE(ended.summary["behavior"], behavior);
    QCOMPARE(ended.summary["seed"], seed);
    QCOMPARE(ended.summary["cells"], QJsonValue(0));
    QVERIFY(ended.summary["rmse_m"].isNull() && ended.summary["collisions"].isNull());
}

void tst_UsarMission::aProgramWithoutItsFilesSaysWhatIsMissing_data() {
    QTest::addColumn<QStringList>("options");
    QTest::addColumn<QString>("words");
    QTest::newRow("worlds") << QStringList{} << "there is no such world. There is none at all in ";
    QTest::newRow("plugins") << QStringList{"--connect", "127.0.0.1:9"} << "No robot plugin could be loaded from ";
}

void tst_UsarMission::aProgramWithoutItsFilesSaysWhatIsMissing() {
    QFETCH(QStringList, options);
    QFETCH(QString, words);
    QVERIFY(QDir(folder_->path()).mkdir("bin"));
    const QString alone = folder_->filePath("bin/usar-mission");
    QVERIFY(QFile::copy(program, alone));
    QProcess process;
    process.start(alone, QStringList{"run", missionFile(small)} + options);
    const Ended ended = read(process);
    QVERIFY2(ended.exit_code == 2, ended.out + ended.err);
    const QString reason = ended.summary["reason"].toString();
    QVERIFY2(reason.contains(words) && reason.contains(folder_->path()), qPrintable(reason));
    for (const char* key : promised_keys)
        QVERIFY2(ended.summary.contains(key), key);
}

void tst_UsarMission::helpGoesToStandardOutput() {
    const Ended ended = run({"run", "--help"});
    QCOMPARE(ended.exit_code, 0);
    QVERIFY(ended.out.contains("--connect HOST:PORT"));
}

void tst_UsarMission::ctrlCKeepsWhatWasScanned_data() {
    QTest::addColumn<int>("signal_number");
    QTest::newRow("Ctrl+C") << SIGINT;
    QTest::newRow("a polite kill") << SIGTERM;
}

void tst_UsarMission::ctrlCKeepsWhatWasScanned() {
    QFETCH(int, signal_number);
    const QString out = folder_->filePath("results");
    QProcess process;
    process.start(program,
                  {"run", USAR_SOURCE_DIR "/resources/missions/quick_scan.json", "--speed", "30", "--out", out});
    process.setReadChannel(QProcess::StandardError);
    QByteArray err; // a line at each tenth, or soon after it: from 10 % on something has been scanned
    static const QRegularExpression two_digits("\\] +[1-9]\\d+ %");
    while (!QString::fromUtf8(err).contains(two_digits) && process.waitForReadyRead(patience_ms))
        err += process.readAllStandardError();
    QVERIFY2(usar::test::sendSignal(process.processId(), signal_number), err);
    const Ended ended = read(process);
    QVERIFY2(ended.exit_code == 1, ended.out + ended.err);
    QVERIFY2(ended.summary["reason"].toString().contains("Interrupted"), ended.out);
    QVERIFY(ended.summary["cells"].toInt() > 0);
    QVERIFY(QDir(out).entryList({"*.bil"}).size() == 1);
    QVERIFY(QDir(out).entryList({"*.json"}).size() == 1);
}

USAR_TEST(tst_UsarMission)

} // namespace tst_usar_mission

#include "tst_usar_mission.moc"
