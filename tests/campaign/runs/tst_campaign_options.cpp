#include <QTest>

#include "core/campaign/runs/campaign_options.h"
#include "core/campaign/runs/slurm_script.h"
#include "tests/suite/suite.h"

namespace tst_campaign_options {

using namespace usar;
using namespace usar::campaign;

class tst_CampaignOptions : public QObject {
    Q_OBJECT
private slots:
    void readsWhatIsTyped() {
        const auto options =
            readCampaignOptions({"campaign", "c.json", "--out", "o", "--jobs", "3", "--resume", "--shard", "2/5",
                                 "--check-every", "0", "--runs", "50", "--first-seed", "9", "--shrink", "s.jsonl"});
        QVERIFY2(options, options ? "" : options.error().text().c_str());
        QVERIFY((*options == CampaignOptions{.file = "c.json",
                                             .folder = "o",
                                             .jobs = 3,
                                             .resume = true,
                                             .shard = Shard{2, 5},
                                             .check_every = 0,
                                             .runs = 50,
                                             .first_seed = 9,
                                             .shrink = "s.jsonl"}));
        const auto script = readCampaignOptions({"campaign", "c.json", "--out", "o", "--slurm", "8"});
        QVERIFY(script && script->slurm == 8);
        const auto least = readCampaignOptions({"campaign", "--out=o", "c.json", "--until-decided"});
        QVERIFY(least && (*least == CampaignOptions{.file = "c.json", .folder = "o", .until_decided = true}));
        const auto tests = readCampaignOptions({"campaign", "--tests", "t", "--junit", "j.xml"});
        QVERIFY2(tests, tests ? "" : tests.error().text().c_str());
        QVERIFY((*tests == CampaignOptions{.file = {}, .tests = "t", .junit = "j.xml", .folder = {}}));
    }

    void rejectsTheRestAndSaysHow_data() {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("words");
        QTest::newRow("no file") << QStringList{"--out", "o"} << "Write usar-mission campaign";
        QTest::newRow("no folder") << QStringList{"c"} << "--out is missing";
        QTest::newRow("two files") << QStringList{"c", "d", "--out", "o"} << "not how to call it";
        QTest::newRow("unknown") << QStringList{"c", "--fast"} << "--fast";
        for (const char* shard : {"4/4", "-1/4", "1", "1/0", "a/4", "1/4/2", "0/1001", ""})
            QTest::newRow(qPrintable(QString("shard ") + shard))
                << QStringList{"c", "--out", "o", "--shard", shard} << "For example";
        QTest::newRow("a part that decides")
            << QStringList{"c", "--out", "o", "--shard", "0/2", "--until-decided"} << "cannot decide";
        QTest::newRow("no jobs") << QStringList{"c", "--out", "o", "--jobs", "0"} << "--jobs 4";
        QTest::newRow("a script that shrinks")
            << QStringList{"c", "--out", "o", "--slurm", "4", "--shrink", "s"} << "does not shrink";
        QTest::newRow("a script for a part")
            << QStringList{"c", "--out", "o", "--slurm", "4", "--shard", "0/4"} << "--slurm --shard";
        QTest::newRow("a script that decides")
            << QStringList{"c", "--out", "o", "--slurm", "4", "--until-decided"} << "--slurm --until-decided";
        QTest::newRow("no runs") << QStringList{"c", "--out", "o", "--runs", "0"} << "--runs 4";
        QTest::newRow("no seed") << QStringList{"c", "--out", "o", "--first-seed", "-1"} << "--first-seed 4";
        QTest::newRow("tests and a file") << QStringList{"c", "--tests", "t"} << "not how to call it";
        QTest::newRow("tests in parts") << QStringList{"--tests", "t", "--shard", "0/2"} << "--shard: tests are flown";
        QTest::newRow("tests with other seeds") << QStringList{"--tests", "t", "--first-seed", "2"} << "own seeds";
        QTest::newRow("JUnit of a campaign") << QStringList{"c", "--out", "o", "--junit", "j"} << "compare DIR --junit";
        QTest::newRow("too many tasks") << QStringList{"c", "--out", "o", "--slurm", "1001"} << "from 1 to 1000";
    }

    void rejectsTheRestAndSaysHow() {
        QFETCH(QStringList, arguments);
        QFETCH(QString, words);
        const auto options = readCampaignOptions(QStringList{"campaign"} + arguments);
        QVERIFY(!options);
        const QString said = QString::fromStdString(options.error().text());
        const bool shard = words == "For example" && said.contains("--shard 0/4");
        QVERIFY2(shard || said.contains(words), qPrintable(said));
    }

    void theJobScriptNamesWhatItNeeds() {
        CampaignOptions options{
            .file = "/my c.json", .folder = "/results", .check_every = 7, .slurm = 40, .runs = 50, .first_seed = 9};
        const QString script = slurmScript(options, "/opt/usar-mission");
        for (const char* line : {"#SBATCH --array=0-39\n", "#SBATCH --requeue\n", "#SBATCH --signal=B:TERM@60\n",
                                 "program=/opt/usar-mission\n", "campaign='/my c.json'\n", "results=/results\n",
                                 "$SLURM_ARRAY_TASK_ID/40\" --runs 50 --first-seed 9 --check-every 7\n"})
            QVERIFY2(script.contains(line), line);
    }
};

USAR_TEST(tst_CampaignOptions)

} // namespace tst_campaign_options

#include "tst_campaign_options.moc"
