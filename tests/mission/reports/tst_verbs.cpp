// The verbs of usar-mission that read files, run without the program.
#include <QBuffer>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include "core/mission/reports/replay_verb.h"
#include "core/mission/runs/mission_runner.h"
#include "tests/suite/suite.h"

namespace tst_verbs {

using namespace usar;
using namespace usar::mission;

namespace {

/// What a verb was given on standard input, and what it wrote.
struct Trial {
    QByteArray typed;
    QByteArray written;
    std::string complaints;

    template <class Run>
    auto run(Run verb) {
        QBuffer input(&typed), output(&written);
        input.open(QIODevice::ReadOnly);
        output.open(QIODevice::WriteOnly);
        return verb({input, output, [this](const std::string& text) { complaints += text + "\n"; }});
    }
    int report(const QStringList& arguments) {
        return run([&](const VerbStreams& streams) { return runReportVerb(arguments, {}, streams); });
    }
};

} // namespace

class tst_Verbs : public QObject {
    Q_OBJECT
private slots:
    void theExitCodeTellsWhetherAllIsWell_data();
    void theExitCodeTellsWhetherAllIsWell();
    void otherVerbsAreNotTheirs();
    void aFileThatCannotBeReadDoesNotHideTheOthers();
    void anExistingFileIsNotOverwritten();
    void aFailedConversionLeavesNoFile();
    void aRecordingThatIsMissingIsReported();
};

void tst_Verbs::aRecordingThatIsMissingIsReported() {
    Trial trial;
    const int exit_code = trial.run([&](const VerbStreams& streams) {
        return runReplayVerb({"replay", "/no/such.usarrec"}, streams,
                             [](ReplayRunner&) { QFAIL("nothing is played"); });
    });
    QCOMPARE(exit_code, int(BadInput));
    QVERIFY(trial.complaints.find("/no/such.usarrec") != std::string::npos);
    QVERIFY(QJsonDocument::fromJson(trial.written).object().contains("reason"));
}

void tst_Verbs::theExitCodeTellsWhetherAllIsWell_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QByteArray>("typed");
    QTest::addColumn<int>("exit_code");
    QTest::addColumn<int>("lines_written");
    const QByteArray line =
        "STA {Type GroundVehicle} {Time 1.0} {LightToggle False} {LightIntensity 0} {Battery 1200}\n";
    QTest::newRow("lines: good") << QStringList{"lines", "-"} << line << int(Done) << 1;
    QTest::newRow("lines: one is broken") << QStringList{"lines", "-"} << line + "STA {Type\n" << 1 << 2;
    QTest::newRow("lines: wrong call") << QStringList{"lines"} << QByteArray() << int(BadInput) << 0;
    QTest::newRow("check-plan: broken") << QStringList{"check-plan", "-"} << QByteArray("((") << 1 << 1;
    QTest::newRow("check-plan: unknown robot")
        << QStringList{"check-plan", "--robot", "Nobody", "-"} << QByteArray() << int(BadInput) << 0;
    QTest::newRow("plan-report: wrong call") << QStringList{"plan-report"} << QByteArray() << int(BadInput) << 0;
}

void tst_Verbs::theExitCodeTellsWhetherAllIsWell() {
    QFETCH(QStringList, arguments);
    QFETCH(QByteArray, typed);
    QFETCH(int, exit_code);
    Trial trial{typed, {}, {}};
    QCOMPARE(trial.report(arguments), exit_code);
    QTEST(static_cast<int>(trial.written.count('\n')), "lines_written");
    QCOMPARE(trial.complaints.empty(), exit_code != BadInput);
}

void tst_Verbs::otherVerbsAreNotTheirs() {
    for (const char* const verb : {"", "run", "replay", "recording-to-text"})
        QVERIFY2(!isReportVerb(verb), verb);
}

void tst_Verbs::aFileThatCannotBeReadDoesNotHideTheOthers() {
    Trial trial{"((", {}, {}};
    QCOMPARE(trial.report({"check-plan", "no/such/file.lap", "-"}), int(BadInput));
    QVERIFY(trial.complaints.find("no/such/file.lap") != std::string::npos);
    QVERIFY(trial.written.contains("\"error\""));
}

void tst_Verbs::anExistingFileIsNotOverwritten() {
    QTemporaryDir folder;
    ReplayOptions options;
    options.verb = ReplayVerb::ToRecording;
    options.file = "-";
    options.output = folder.filePath("flight.usarrec");
    QFile file(options.output);
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write("kept") == 4);
    file.close();
    Trial trial;
    QCOMPARE(trial.run([&](const VerbStreams& streams) { return convertRecording(options, streams); }), int(BadInput));
    QVERIFY(trial.complaints.find("left alone") != std::string::npos);
    QCOMPARE(file.size(), 4);
}

void tst_Verbs::aFailedConversionLeavesNoFile() {
    QTemporaryDir folder;
    ReplayOptions options;
    options.verb = ReplayVerb::ToRecording;
    options.file = "-";
    options.output = folder.filePath("flight.usarrec");
    Trial trial{"this is no recording", {}, {}};
    QCOMPARE(trial.run([&](const VerbStreams& streams) { return convertRecording(options, streams); }), int(BadInput));
    QVERIFY(!trial.complaints.empty());
    QVERIFY(!QFile::exists(options.output));
}

USAR_TEST(tst_Verbs)

} // namespace tst_verbs

#include "tst_verbs.moc"
