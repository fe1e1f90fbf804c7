
#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTest>

#include "core/base/version.h"
#include "core/campaign/runs/shard_file.h"
#include "tests/loop/program_folder.h"
#include "tests/suite/suite.h"

namespace tst_usar_campaign {

using namespace usar;
using namespace usar::campaign;
using test::ProgramFolder;

namespace {

const QByteArray two_behaviors = R"({ "name": "Two", "missions": ["small.json"], "seeds": 3, "variants": [
    { "name": "C++", "behavior": "airrobot/cpp" }, { "name": "POSH", "behavior": "airrobot/posh" }] })";

} // namespace

/// Campaigns by the program itself.
class tst_UsarCampaign : public QObject {
    Q_OBJECT
private slots:
    void init() {
        folder_ = std::make_unique<ProgramFolder>();
        folder_->write("small.json", test::small_mission);
    }

    void fliesItsMissionsAndTellsTheCommandOfEach() {
        folder_->write("two.json", two_behaviors);
        const ProgramFolder::Ended ended = folder_->run({"campaign", "two.json", "--out", "results"});
        QVERIFY2(ended.exit_code == 0, ended.err);
        QCOMPARE(ended.summary["outcomes"].toObject()["done"].toInt(), 6);
        QVERIFY(ended.summary["complete"].toBool());
        const auto results = readResults(folder_->path("results"), versionOf());
        QVERIFY2(results, results ? "" : results.error().text().c_str());
        QCOMPARE(results->size(), std::size_t(6));
        QVERIFY(results->front().differences == QStringList{});
        const RunResult& last = results->back();
        QCOMPARE(last.summary["behavior"].toString(), QString("airrobot/posh"));
        QCOMPARE(last.seed, std::uint64_t(3));
        QProcess again;
        again.setWorkingDirectory(folder_->path());
        again.start("/bin/sh",
                    {"-c", QString(last.command).replace("usar-mission", ProgramFolder::program()) + " --out again"});
        QVERIFY(again.waitForFinished(ProgramFolder::patience_ms));
        const QByteArray out = again.readAllStandardOutput().trimmed();
        const QJsonObject summary = QJsonDocument::fromJson(out.mid(out.lastIndexOf('\n') + 1)).object();
        QCOMPARE(differencesOf(last.summary, summary), QStringList());
    }

    void whatWasFlownIsCompared() {
        folder_->write("two.json", two_behaviors);
        QCOMPARE(folder_->run({"campaign", "two.json", "--out", "results"}).exit_code, 0);
        const ProgramFolder::Ended compared =
            folder_->run({"compare", "results", "--json", "--html", "report.html", "--junit", "runs.xml"});
        QCOMPARE(compared.exit_code, 3); // Three pairs decide nothing.
        QCOMPARE(compared.summary["baseline"].toString(), QString("C++"));
        QCOMPARE(compared.summary["candidate"].toString(), QString("POSH"));
        QCOMPARE(compared.summary["pairs"].toInt(), 3);
        QCOMPARE(compared.summary["facts"].toObject()["runs"].toString(), QString("6 of 6"));
        for (const char* file : {"report.html", "runs.xml"})
            QVERIFY2(QFile(folder_->path(file)).size() > 300, file);
        const ProgramFolder::Ended unknown = folder_->run({"compare", "results", "--candidate", "Lisp"});
        QCOMPARE(unknown.exit_code, 2);
        QVERIFY2(unknown.err.contains("Lisp"), unknown.err);
    }

    void aSingleVariantIsReportedWithoutAVerdict() {
        folder_->write("one.json", "{ \"name\": \"One\", \"missions\": [\"small.json\"], \"seeds\": 2 }");
        QCOMPARE(folder_->run({"campaign", "one.json", "--out", "results"}).exit_code, 0);
        const ProgramFolder::Ended ended = folder_->run(
            {"compare", "results", "--json", "--html", "one.html", "--junit", "one.xml", "--curve", "one.svg"});
        QVERIFY2(ended.exit_code == 0, ended.err);
        QCOMPARE(ended.summary["runs"].toInt(), 2);
        QVERIFY(!ended.summary.contains("cpu_s")); // It is a run's.
        for (const char* file : {"one.html", "one.xml", "one.svg"})
            QVERIFY2(QFile(folder_->path(file)).size() > 300, file);
        QCOMPARE(folder_->run({"compare", "results", "--candidate", "POSH"}).exit_code, 2);
    }

    void allVariantsAreComparedWithTheFirst() {
        folder_->write("three.json", R"({ "name": "Three", "missions": ["small.json"], "seeds": 2, "variants": [
            { "name": "as written" }, { "name": "fast", "set": { "preset": "fast", "adjust": true } },
            { "name": "POSH", "behavior": "airrobot/posh" }] })");
        QCOMPARE(folder_->run({"campaign", "three.json", "--out", "results"}).exit_code, 0);
        const ProgramFolder::Ended compared =
            folder_->run({"compare", "results", "--json", "--html", "all.html", "--curve", "curve.svg"});
        QCOMPARE(compared.exit_code, 3);
        const QJsonArray comparisons = compared.summary["comparisons"].toArray();
        QCOMPARE(comparisons.size(), 2);
        QCOMPARE(comparisons[0]["candidate"].toString(), QString("fast"));
        QCOMPARE(comparisons[1]["candidate"].toString(), QString("POSH"));
        for (const char* file : {"all.html", "curve.svg"}) {
            QFile page(folder_->path(file));
            QVERIFY2(page.open(QIODevice::ReadOnly), file);
            QVERIFY(page.readAll().contains("POSH"));
        }
        QCOMPARE(folder_->run({"compare", "results", "--candidate", "POSH", "--json"}).summary["candidate"].toString(),
                 QString("POSH"));
    }

    void theShippedCampaignsCanBeFlown() {
        const QDir shipped(USAR_SOURCE_DIR "/resources/campaigns");
        const QStringList files = shipped.entryList({"*.json"});
        QVERIFY(!files.isEmpty());
        for (const QString& file : files) { // The last of so many parts has no run, but all of them are checked.
            const ProgramFolder::Ended ended =
                folder_->run({"campaign", shipped.filePath(file), "--out", file, "--runs", "1", "--shard", "999/1000"});
            QVERIFY2(ended.exit_code == 0, ended.err);
            QCOMPARE(ended.summary["done"].toInt(), 0);
        }
    }

    void aVariantThatNoRunCouldFlyIsRefusedBeforeTheFirst_data() {
        QTest::addColumn<QByteArray>("values");
        QTest::addColumn<QByteArray>("said");
        QTest::newRow("an unknown key") << QByteArray(R"("set": {"adjusts": true})")
                                        << QByteArray("Did you mean \"adjust\"?");
        QTest::newRow("an unknown preset") << QByteArray(R"("set": {"preset": "fest"})")
                                           << QByteArray("has no preset \"fest\". Did you mean \"fast\"?");
        QTest::newRow("a parameter out of range")
            << QByteArray(R"("set": {"parameters.scan_altitude_m": 99})") << QByteArray("99 is out of range");
        QTest::newRow("a behavior that nobody has, told of the variant and not of the mission's file")
            << QByteArray(R"("behavior": "airrobot/lisp")")
            << QByteArray("wrong.json:2:70: behavior airrobot/lisp: in the variant \"wrong\", no loaded plugin");
        QTest::newRow("an unknown parameter")
            << QByteArray(R"("set": {"parameters.scan_altitude": 8})") << QByteArray("Did you mean scan_altitude_m?");
    }

    void aVariantThatNoRunCouldFlyIsRefusedBeforeTheFirst() {
        QFETCH(QByteArray, values);
        QFETCH(QByteArray, said);
        folder_->write("wrong.json", R"({ "name": "Wrong", "missions": ["small.json"], "variants": [
            { "name": "as written" }, { "name": "wrong", )" +
                                         values + " }] }");
        const ProgramFolder::Ended ended = folder_->run({"campaign", "wrong.json", "--out", "results"});
        QCOMPARE(ended.exit_code, 2);
        QVERIFY2(ended.err.contains(said), ended.err);
        QVERIFY(!QFile::exists(folder_->path("results")));
    }

    void aWorldsFolderBeginsAtTheCampaignsAndIsFoundFromEveryFolder() {
        QVERIFY(QDir(folder_->path()).mkpath("far/worlds"));
        const QDir shipped(QString(USAR_BINARY_DIR) + "/share/worlds/tall_test");
        QVERIFY(QDir(folder_->path("far/worlds")).mkpath("my wood"));
        for (const QString& file : shipped.entryList(QDir::Files))
            QVERIFY(QFile::copy(shipped.filePath(file), folder_->path("far/worlds/my wood/" + file)));
        folder_->write("far/small.json", test::small_mission);
        folder_->write("far/wood.json",
                       R"({ "name": "Wood", "missions": [{ "file": "small.json", "worlds": ["worlds/my wood"] }] })");
        const ProgramFolder::Ended ended = folder_->run({"campaign", "far/wood.json", "--out", "results"});
        QVERIFY2(ended.exit_code == 0, ended.err);
        const auto results = readResults(folder_->path("results"), versionOf());
        QVERIFY(results && results->size() == 1);
        QVERIFY2(results->front().command.contains("'world=" + folder_->path("far/worlds/my wood'")),
                 qPrintable(results->front().command));
    }

    void variantsThatExchangeTheirPlansAreAnotherCampaign() {
        for (const char* plan : {"a.lap", "b.lap"})
            QVERIFY(QFile::copy(USAR_SOURCE_DIR "/resources/plans/airrobot.lap", folder_->path(plan)));
        const auto fly = [&](const QByteArray& first, const QByteArray& second) {
            const QByteArray a = "{ \"name\": \"A\", \"behavior\": \"airrobot/posh\", \"plan\": \"" + first + "\" }";
            const QByteArray b = "{ \"name\": \"B\", \"behavior\": \"airrobot/posh\", \"plan\": \"" + second + "\" }";
            folder_->write("plans.json", "{ \"name\": \"Plans\", \"missions\": [\"small.json\"], \"variants\": [" + a +
                                             ", " + b + "] }");
            return folder_->run({"campaign", "plans.json", "--out", "results", "--shard", "999/1000"});
        };
        const ProgramFolder::Ended planned = fly("a.lap", "b.lap");
        QVERIFY2(planned.exit_code == 0, planned.err);
        QCOMPARE(fly("a.lap", "b.lap").exit_code, 0);
        const ProgramFolder::Ended exchanged = fly("b.lap", "a.lap");
        QCOMPARE(exchanged.exit_code, 2);
        QVERIFY2(exchanged.err.contains("the plan b.lap of A is not what it was"), exchanged.err);
    }

    void whatFindsNoRoomEndsTheCampaignAndIsFlownAgain() {
        folder_->write("kept.json", R"({ "name": "Kept", "missions": ["small.json"], "keep": "everything" })");
        QProcess narrow;
        narrow.setWorkingDirectory(folder_->path());
        narrow.start("/bin/sh", {"-c", "trap '' XFSZ; ulimit -f 20; exec " + ProgramFolder::program() +
                                           " campaign kept.json --out results --check-every 0"});
        QVERIFY(narrow.waitForFinished(ProgramFolder::patience_ms));
        const QByteArray said = narrow.readAllStandardError();
        QCOMPARE(narrow.exitCode(), 2);
        QVERIFY2(said.contains("what is kept of a run cannot be written") && said.contains("--resume"), said);
        const ProgramFolder::Ended resumed = folder_->run({"campaign", "kept.json", "--out", "results", "--resume"});
        QVERIFY2(resumed.exit_code == 0, resumed.err);
        const auto results = readResults(folder_->path("results"), versionOf());
        QVERIFY(results && results->size() == 1 && !results->front().summary.contains("unwritten"));
        QVERIFY(QFile::exists(folder_->path("results/runs/000000/run.usarrec")));
    }

    void aScriptForABrokenCampaignIsNotWritten() {
        folder_->write("bad.json", "{ \"name\": \"A\",\n  \"mission\": [] }");
        const ProgramFolder::Ended ended = folder_->run({"campaign", "--slurm", "4", "bad.json", "--out", "results"});
        QCOMPARE(ended.exit_code, 2);
        QVERIFY2(ended.err.contains("bad.json:2:3: "), ended.err);
    }

    void faultsDoNotMakeEqualSeedsDiffer() {
        folder_->write("cut.json",
                       R"({ "name": "Cut", "missions": ["small.json"], "seeds": 3, "faults": ["link_cut from=40"] })");
        for (const char* results : {"one", "two"}) {
            const ProgramFolder::Ended ended = folder_->run({"campaign", "cut.json", "--out", results});
            QCOMPARE(ended.exit_code, 1);
            QCOMPARE(ended.summary["outcomes"].toObject()["failed"].toInt(), 3);
        }
        const auto one = readResults(folder_->path("one"), versionOf());
        const auto two = readResults(folder_->path("two"), versionOf());
        QVERIFY(one && two);
        for (std::size_t i = 0; i < 3; ++i) {
            QVERIFY(!one->at(i).summary["collisions"].isNull());
            QCOMPARE(differencesOf(one->at(i).summary, two->at(i).summary), QStringList());
        }
    }

    void shardsAndAResumeAfterAKillGiveEachRunOnce() {
        folder_->write("two.json", two_behaviors);
        QProcess killed;
        killed.setWorkingDirectory(folder_->path());
        killed.start(ProgramFolder::program(),
                     {"campaign", "two.json", "--out", "results", "--jobs", "1", "--shard", "0/2"});
        const QString shard = folder_->path("results/shard-000.jsonl");
        QTRY_VERIFY_WITH_TIMEOUT(QFile(shard).size() > 0, ProgramFolder::patience_ms);
        killed.kill();
        QVERIFY(killed.waitForFinished(ProgramFolder::patience_ms));
        QCOMPARE(folder_->run({"campaign", "two.json", "--out", "results", "--shard", "1/2"}).exit_code, 0);
        const ProgramFolder::Ended without = folder_->run({"campaign", "two.json", "--out", "results"});
        QCOMPARE(without.exit_code, 2);
        QVERIFY(without.err.contains("--resume"));
        const ProgramFolder::Ended ended = folder_->run({"campaign", "two.json", "--out", "results", "--shard", "0/2"});
        QVERIFY2(ended.exit_code == 0, ended.err);
        const auto results = readResults(folder_->path("results"), versionOf());
        QVERIFY(results);
        QCOMPARE(results->size(), std::size_t(6));
        qsizetype lines = 0;
        for (const char* name : {"results/shard-000.jsonl", "results/shard-001.jsonl"}) {
            QFile file(folder_->path(name));
            QVERIFY(file.open(QIODevice::ReadOnly));
            lines += file.readAll().count('\n');
        }
        QCOMPARE(lines, qsizetype(6));
    }

    void aStoppedCampaignTellsHowItGoesOn() {
        folder_->write("two.json", two_behaviors);
        QProcess stopped;
        stopped.setWorkingDirectory(folder_->path());
        stopped.start(ProgramFolder::program(), {"campaign", "two.json", "--out", "results", "--jobs", "1"});
        QTRY_VERIFY_WITH_TIMEOUT(QFile(folder_->path("results/shard-000.jsonl")).size() > 0,
                                 ProgramFolder::patience_ms);
        stopped.terminate();
        QVERIFY(stopped.waitForFinished(ProgramFolder::patience_ms));
        const QByteArray said = stopped.readAllStandardError();
        QCOMPARE(stopped.exitCode(), 1);
        QVERIFY2(said.contains(" of 6 runs. The same command with --resume flies the others."), said);
    }

    void wrongInputIsSaidBeforeAnythingIsFlown_data() {
        QTest::addColumn<QByteArray>("campaign");
        QTest::addColumn<QString>("words");
        const auto with = [](const QByteArray& rest) {
            return QByteArray("{ \"name\": \"A\", \"missions\": [\"small.json\"], " + rest + " }");
        };
        QTest::newRow("no JSON") << QByteArray("{ \"name\": }") << "bad.json:1:";
        QTest::newRow("no mission") << QByteArray(R"({ "name": "A", "missions": ["none.json"] })") << "bad.json:1:28: ";
        QTest::newRow("no mission, in an object")
            << QByteArray("{ \"name\": \"A\",\n  \"missions\": [{ \"file\": \"none.json\" }] }") << "bad.json:2:26: ";
        QTest::newRow("no fault") << with("\n  \"faults\": [\"wnd\"]") << "bad.json:2:13: ";
        QTest::newRow("no kind of fault")
            << with("\n\"swarm\": { \"kinds\": [\"wnd\"] }") << "bad.json:2:21: wnd: there is no such kind";
        QTest::newRow("no plan")
            << with("\n\"variants\": [{ \"name\": \"x\", \"behavior\": \"airrobot/posh\", \"plan\": \"none.lap\" }]")
            << "bad.json:2:66: ";
        QTest::newRow("no value") << with("\n\"variants\": [{ \"name\": \"x\", \"set\": { \"area.with\": 3 } }]")
                                  << "bad.json:2:51: ";
        QTest::newRow("no world") << with("\n\"variants\": [{ \"name\": \"x\", \"set\": { \"world\": \"moon\" } }]")
                                  << "bad.json:2:47: world moon: ";
        QTest::newRow("no world of the mission's")
            << QByteArray("{ \"name\": \"A\", \"missions\": [{ \"file\": \"small.json\",\n\"worlds\": [\"moon\"] }] }")
            << "bad.json:2:11: world moon: ";
        QTest::newRow("a draw that does not fit")
            << QByteArray("{ \"name\": \"A\", \"missions\": [{ \"file\": \"small.json\",\n\"draw\": { \"area.q\": [1, "
                          "2] } }] }")
            << "bad.json:2:21: --set area.q=";
    }

    void wrongInputIsSaidBeforeAnythingIsFlown() {
        QFETCH(QByteArray, campaign);
        QFETCH(QString, words);
        folder_->write("bad.json", campaign);
        const ProgramFolder::Ended ended = folder_->run({"campaign", "bad.json", "--out", "results"});
        QCOMPARE(ended.exit_code, 2);
        QVERIFY2(ended.err.contains(words.toUtf8()), ended.err);
        QVERIFY(!ended.summary["reason"].toString().isEmpty());
        QVERIFY(!QFile::exists(folder_->path("results")));
    }

private:
    static std::string versionOf() { return std::string(version()); }

    std::unique_ptr<ProgramFolder> folder_;
};

USAR_TEST(tst_UsarCampaign)

} // namespace tst_usar_campaign

#include "tst_usar_campaign.moc"
