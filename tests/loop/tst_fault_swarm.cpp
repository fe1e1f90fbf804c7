#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include "core/base/version.h"
#include "core/campaign/plan/known_failures.h"
#include "core/campaign/runs/shard_file.h"
#include "tests/doubles/test_files.h"
#include "tests/suite/suite.h"

namespace tst_fault_swarm {

using namespace usar;

namespace {

const QString program = QString(USAR_BINARY_DIR) + "/bin/usar-mission";
constexpr int patience_ms = 700000;

struct Ended {
    QJsonObject summary; ///< last line of standard output; empty if the program did not end in time
    QByteArray err;
};

Ended fly(const QString& folder, const QStringList& arguments) {
    QProcess process;
    process.setWorkingDirectory(folder);
    process.start(program, QStringList{"campaign"} + arguments);
    if (!process.waitForFinished(patience_ms))
        return {};
    const QByteArray out = process.readAllStandardOutput().trimmed();
    return {QJsonDocument::fromJson(out.mid(out.lastIndexOf('\n') + 1)).object(), process.readAllStandardError()};
}

} // namespace

/// Random sets of faults must not bring the program to do what no program should, whatever they do to the robot.
class tst_FaultSwarm : public QObject {
    Q_OBJECT
private slots:
    void sixtySetsOfFaultsShowNoDefect() {
        const QTemporaryDir folder;
        const Ended ended = fly(folder.path(), {USAR_SOURCE_DIR "/resources/campaigns/swarm_of_faults.json", "--out",
                                                "results", "--check-every", "6"});
        QVERIFY2(ended.summary["complete"].toBool(), ended.err);
        QVERIFY(ended.summary["runs"].toInt() >= 60);
        QVERIFY2(ended.summary["unsound"].toArray().isEmpty(), ended.err);
        // The faults reach the robot: without any, all would be done.
        QVERIFY(ended.summary["outcomes"]["failed"].toInt() >= 5);
        QVERIFY(ended.summary["outcomes"]["done"].toInt() >= 5);
    }

    /// A run that takes longer than its limit of wall time counts as one that hangs.
    void whatHangsIsKeptWithItsFewestFaultsAndFlownAgain() {
        const QTemporaryDir folder;
        doubles::writeAll(doubles::pathOf(folder) / "small.json",
                          R"({ "name": "Small", "area": { "x": -8, "y": -6, "width": 16, "height": 12 } })");
        doubles::writeAll(doubles::pathOf(folder) / "hangs.json",
                          R"({ "name": "Hangs", "missions": ["small.json"], "wall_limit_s": 0.02,
                               "again": "again.jsonl", "faults": ["wind speed=1", "vanish from=50"] })");
        const Ended first = fly(folder.path(), {"hangs.json", "--out", "first", "--shrink", "again.jsonl"});
        QVERIFY2(first.summary["unsound"].toArray() == QJsonArray{0}, first.err);
        const auto known = campaign::readKnownFailures(folder.filePath("again.jsonl"));
        QVERIFY2(known, known ? "" : known.error().text().c_str());
        QCOMPARE(known->size(), std::size_t(1));
        QVERIFY(known->front().faults.empty());
        QVERIFY(known->front().broke.starts_with("It ended as timed-out: "));
        const Ended second = fly(folder.path(), {"hangs.json", "--out", "second", "--runs", "3"});
        QCOMPARE(second.summary["runs"].toInt(), 4);
        const auto results = campaign::readResults(folder.filePath("second"), std::string(version()));
        QVERIFY2(results, results ? "" : results.error().text().c_str());
        QCOMPARE(results->size(), std::size_t(4));
        QCOMPARE(results->back().seed, known->front().seed);
        QVERIFY2(!results->back().command.contains("--fault"), qPrintable(results->back().command));
        QVERIFY(results->front().command.contains("--fault"));
    }
};

USAR_TEST(tst_FaultSwarm)

} // namespace tst_fault_swarm

#include "tst_fault_swarm.moc"
