// Runs of plans out of files: put together plan by plan, and reported on.
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include "core/agent/published_text.h"
#include "core/link/recording_writer.h"
#include "core/mission/reports/recorded_runs.h"
#include "core/mission/reports/run_report_text.h"
#include "tests/doubles/plan_trace.h"
#include "tests/suite/suite.h"

namespace tst_recorded_runs {

using namespace usar;
using namespace usar::mission;

namespace {

const std::string rover = "((DC rover (drives ((danger (trigger ((near))) back)) ((way go)))))";
const std::string other = "((DC other (drives ((way go)))))";

std::string traceOf(const std::string& plan, int cycles, int near = 0) {
    std::string trace;
    for (const std::string& piece : test::piecesOf(plan, cycles, near))
        trace += piece;
    return trace;
}

std::vector<QJsonObject> objectsIn(const QByteArray& lines) {
    std::vector<QJsonObject> objects;
    for (const QByteArray& line : lines.trimmed().split('\n'))
        objects.push_back(QJsonDocument::fromJson(line).object());
    return objects;
}

} // namespace

class tst_RecordedRuns : public QObject {
    Q_OBJECT
private slots:
    void eachRunOfARecordingIsATrace() {
        {
            auto writer = link::RecordingWriter::create(path("two.usarrec"), {}, {});
            QVERIFY(writer);
            for (const std::string& plan : {rover, other})
                for (const std::string& piece : test::piecesOf(plan, 7)) {
                    std::string text;
                    appendText(text, agent::PlanTrace{piece});
                    (*writer)->write({.kind = link::RecordKind::Note, .name = "published", .bytes = text});
                    (*writer)->write({.kind = link::RecordKind::Note, .name = "published", .bytes = "goal -"});
                }
        }
        const auto recorded = readTraces(path("two.usarrec"));
        QVERIFY2(recorded, recorded ? "" : recorded.error().text().c_str());
        QCOMPARE(recorded->traces.size(), std::size_t(2));
        QVERIFY(recorded->traces[0] == traceOf(rover, 7));
        QVERIFY(recorded->traces[1] == traceOf(other, 7));
    }

    void aTraceIsAFileToo() {
        writeFile("one.trace", traceOf(rover, 7));
        const auto recorded = readTraces(path("one.trace"));
        QVERIFY(recorded && recorded->traces.size() == 1);
        QVERIFY(recorded->traces.front() == traceOf(rover, 7));
    }

    void whatIsNeitherIsRefused_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("words");
        QTest::newRow("no such file") << "none"
                                      << "Check the name";
        QTest::newRow("a text") << "a.lap"
                                << "byte 0 does not begin a recording";
        QTest::newRow("a recording without a plan") << "empty.usarrec"
                                                    << "no plan ran in this recording";
    }

    void whatIsNeitherIsRefused() {
        QFETCH(QString, name);
        QFETCH(QString, words);
        writeFile("a.lap", rover);
        QVERIFY(link::RecordingWriter::create(path("empty.usarrec"), {}, {}) || QFile::exists(path("empty.usarrec")));
        const auto recorded = readTraces(folder_.filePath(name));
        QVERIFY(!recorded);
        const QString said = QString::fromStdString(recorded.error().text());
        QVERIFY2(said.contains(words) && said.contains(name), qPrintable(said));
    }

    void runsOfOnePlanAddUp() {
        std::vector<PlanRuns> plans;
        for (const std::string& trace : {traceOf(rover, 5), traceOf(other, 6), traceOf(rover, 7, 2)})
            QCOMPARE(addRuns(trace, plans), std::string());
        QCOMPARE(plans.size(), std::size_t(2));
        QCOMPARE(plans[0].runs, 2);
        QCOMPARE(plans[0].statistics.cycles(), std::uint64_t(12));
        QCOMPARE(plans[1].runs, 1);
    }

    void aPlanReplacedOnTheWayIsARunOfEach() {
        test::StubHost host;
        posh::TraceEncoder encoder(rover);
        posh::Engine engine(host, *posh::compile(posh::readPlan(rover).plan));
        engine.watch(&encoder);
        for (int cycle = 1; cycle <= 7; ++cycle) {
            if (cycle == 4) {
                encoder.setPlanText(other);
                engine.replace(*posh::compile(posh::readPlan(other).plan));
            }
            engine.cycle(posh::Milliseconds(200 * cycle));
        }
        engine.watch(nullptr);
        std::vector<PlanRuns> plans;
        QCOMPARE(addRuns(encoder.takeBytes(), plans), std::string());
        QCOMPARE(plans.size(), std::size_t(2));
        QCOMPARE(plans[0].statistics.program()->title, std::string("rover"));
        QCOMPARE(plans[0].statistics.cycles(), std::uint64_t(3));
        QCOMPARE(plans[1].statistics.cycles(), std::uint64_t(4));
    }

    void aDamagedTraceIsReadAsFarAsItGoes() {
        std::vector<PlanRuns> plans;
        const std::string whole = traceOf(rover, 300);
        QCOMPARE(addRuns(whole.substr(0, whole.size() - 3), plans), std::string());
        QVERIFY(plans.size() == 1 && plans[0].statistics.cycles() > 200);
        QVERIFY(addRuns(whole + "\x02?!", plans).find("damaged at byte") != std::string::npos);
        QVERIFY(!addRuns("nonsense", plans).empty());
        QVERIFY(addRuns(traceOf(rover, 3).replace(traceOf(rover, 3).find("drives"), 6, "driven"), plans)
                    .find("cannot be read") != std::string::npos);
    }

    void thePersonReadsFindingsAndWhereTheTimeWent() {
        std::vector<PlanRuns> plans;
        addRuns(traceOf(rover, 11, 2), plans);
        const QString text = QString::fromStdString(runReportText(plans[0].statistics, plans[0].runs));
        QVERIFY2(text.startsWith("rover: 1 run, 11 cycles, 2.0 s\n"), qPrintable(text));
        QVERIFY2(text.contains("   20.0 %        0.4 s"), qPrintable(text));
        QVERIFY2(text.contains("   80.0 %        1.6 s"), qPrintable(text));
        std::vector<PlanRuns> never;
        addRuns(traceOf(rover, 4), never);
        const QString said = QString::fromStdString(runReportText(never[0].statistics, 1));
        QVERIFY2(said.contains("  never-selected: rover ▸ danger never started in 4 cycles\n"), qPrintable(said));
        QVERIFY2(said.contains("  never-true: rover ▸ danger ▸ near"), qPrintable(said));
    }

    void theMachineReadsALineForEachThing() {
        std::vector<PlanRuns> plans;
        addRuns(traceOf(rover, 4), plans);
        const std::vector<QJsonObject> lines = objectsIn(runReportJson(plans[0].statistics, plans[0].runs));
        QCOMPARE(lines.front()["kind"].toString(), QString("plan"));
        QCOMPARE(lines.front()["cycles"].toInt(), 4);
        QCOMPARE(lines[1]["kind"].toString(), QString("finding"));
        QCOMPARE(lines[1]["remark"].toString(), QString("never-selected"));
        QCOMPARE(lines[1]["path"].toString(), QString("/P:0/DC:0/DE:0"));
        QCOMPARE(lines[1]["column"].toInt(), 22);
        const auto element = [&](const char* name) {
            for (const QJsonObject& line : lines)
                if (line["kind"].toString() == "element" && line["name"].toString().endsWith(name))
                    return line;
            return QJsonObject();
        };
        QCOMPARE(element("▸ way")["time_pct"].toDouble(), 100.0);
        QCOMPARE(element("▸ near")["asked"].toInt(), 4);
        QCOMPARE(element("▸ near")["held"].toInt(-1), 0);
        QCOMPARE(element("▸ go")["cycles"].toInt(), 4);
        QCOMPARE(element("▸ go")["type"].toString(), QString("act"));
    }

private:
    QString path(const char* name) const { return folder_.filePath(name); }

    void writeFile(const char* name, const std::string& bytes) const {
        QFile file(path(name));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(QByteArray::fromStdString(bytes));
    }

    QTemporaryDir folder_;
};

USAR_TEST(tst_RecordedRuns)

} // namespace tst_recorded_runs

#include "tst_recorded_runs.moc"
