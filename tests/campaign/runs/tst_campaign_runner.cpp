#include <QDir>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "core/campaign/runs/campaign_runner.h"
#include "core/campaign/runs/campaign_words.h"
#include "tests/doubles/test_files.h"
#include "tests/suite/suite.h"

namespace tst_campaign_runner {

using namespace usar;
using namespace usar::campaign;

namespace {

constexpr int patience_ms = 20000;

} // namespace

class tst_CampaignRunner : public QObject {
    Q_OBJECT
private slots:
    void init() {
        folder_ = std::make_unique<QTemporaryDir>();
        const auto program = doubles::pathOf(*folder_) / "program";
        doubles::writeAll(program, doubles::readAll(USAR_SOURCE_DIR "/tests/data/campaign/program.sh"));
        std::filesystem::permissions(program, std::filesystem::perms::owner_all);
        campaign_ = {};
        campaign_.missions = {{"/m/a.json", 1, 8, {}, {}}};
        campaign_.variants = {{"plain", {}, {}, {}}};
        campaign_.wall_limit_s = 60.0; // Nothing but what sleeps takes so long, also on a machine that is busy.
    }

    void everyEndHasItsOwnOutcome() {
        campaign_.missions.front().seeds = 11;
        campaign_.wall_limit_s = 3.0;
        const auto runner = runAll(3, 0);
        const auto results = readResults(folder_->path(), "1.0");
        QVERIFY(results);
        QCOMPARE(results->size(), std::size_t(11));
        const std::vector<std::pair<Outcome, const char*>> expected{{Outcome::Done, "Well."},
                                                                    {Outcome::Failed, "It fell."},
                                                                    {Outcome::Refused, "No such world."},
                                                                    {Outcome::Crashed, "crashed"},
                                                                    {Outcome::Killed, "Killed"},
                                                                    {Outcome::OutOfMemory, "memory"},
                                                                    {Outcome::TimedOut, "limit of"},
                                                                    {Outcome::Crashed, "without a result: no plugin"},
                                                                    {Outcome::Done, "Chance."},
                                                                    {Outcome::Killed, "Killed"}, // with its worker
                                                                    {Outcome::Done, "Well."}};
        for (std::size_t i = 0; i < expected.size(); ++i) {
            QCOMPARE(wordOf((*results)[i].outcome), wordOf(expected[i].first));
            QVERIFY2((*results)[i].reason.find(expected[i].second) != std::string::npos, (*results)[i].reason.c_str());
        }
        QCOMPARE(runner->progress().failures(), 8);
        QCOMPARE(exitCodeOf(runner->progress()), 1);
        QVERIFY(!(*results)[0].summary.contains("files"));
    }

    void onlyFilesThatAreWantedStay_data() {
        QTest::addColumn<int>("keep");
        QTest::addColumn<QStringList>("folders");
        QTest::newRow("nothing") << static_cast<int>(Keep::Nothing) << QStringList{};
        QTest::newRow("failures") << static_cast<int>(Keep::Failures) << QStringList{"000001"};
        QTest::newRow("everything") << static_cast<int>(Keep::Everything) << QStringList{"000000", "000001"};
    }

    void onlyFilesThatAreWantedStay() {
        QFETCH(int, keep);
        QFETCH(QStringList, folders);
        campaign_.missions.front().seeds = 2;
        campaign_.keep = static_cast<Keep>(keep);
        runAll(1, 1);
        QCOMPARE(QDir(folder_->filePath("runs")).entryList(QDir::Dirs | QDir::NoDotAndDotDot), folders);
    }

    void onlyWhatIsMissingIsFlown() {
        campaign_.missions.front().seeds = 3;
        runAll(1, 0);
        campaign_.missions.front().seeds = 4;
        const auto runner = runAll(2, 0);
        QCOMPARE(calls(), (QStringList{"1", "2", "3", "4"}));
        QCOMPARE(runner->progress().flown, 1);
        QCOMPARE(runner->progress().done, 4);
    }

    void aShardFliesItsOwnPairs() {
        campaign_.missions.front().seeds = 6;
        runAll(1, 0, {1, 3});
        QCOMPARE(calls(), (QStringList{"2", "5"}));
    }

    void whatIsNotTheSameTwiceIsNamed() {
        campaign_.missions = {{"/m/a.json", 9, 1, {}, {}}, {"/m/b.json", 1, 1, {}, {}}, {"/m/c.json", 12, 1, {}, {}}};
        const auto runner = runAll(2, 1);
        QCOMPARE(runner->progress().different, (std::vector<int>{0, 2}));
        QCOMPARE(exitCodeOf(runner->progress()), 1);
        const auto results = readResults(folder_->path(), "1.0");
        QVERIFY(results && results->size() == 3);
        QVERIFY((*results)[0].differences == QStringList{"pid"});
        QVERIFY((*results)[1].differences == QStringList{});
        QVERIFY((*results)[2].differences == QStringList{"worker"}); // A copy of the same one would repeat its chances.
        QVERIFY(sentenceOf(results->front()).find("came out differently") != std::string::npos);
        QCOMPARE(calls().size(), 6);
    }

    void anInterruptedRunHasNoResult() {
        campaign_.missions = {{"/m/a.json", 7, 1, {}, {}}};
        auto runner = makeRunner(1, 0, {});
        QVERIFY(runner);
        QSignalSpy finished(runner.get(), &CampaignRunner::finished);
        runner->start();
        QTRY_VERIFY_WITH_TIMEOUT(calls().size() == 1, patience_ms);
        runner->interrupt();
        QVERIFY(finished.wait(patience_ms));
        QVERIFY(readResults(folder_->path(), "1.0")->empty());
        QVERIFY(!toJson(runner->progress(), "d")["complete"].toBool());
        QVERIFY(QDir(folder_->filePath("runs")).isEmpty());
    }

    void aRunThatASignalInterruptsIsNoFailure() {
        campaign_.missions = {{"/m/a.json", 13, 1, {}, {}}};
        const auto runner = runAll(1, 1);
        const auto results = readResults(folder_->path(), "1.0");
        QVERIFY(results && results->size() == 1);
        QCOMPARE(wordOf(results->front().outcome), QString("killed"));
        QCOMPARE(calls().size(), 1); // There is nothing with which a second flight could be compared.
    }

    void aRunWhoseFilesFindNoRoomIsNotKept() {
        campaign_.missions = {{"/m/a.json", 13, 3, {}, {}}};
        campaign_.keep = Keep::Everything;
        const auto runner = runAll(1, 0);
        QVERIFY(runner->trouble().has_value());
        QVERIFY2(runner->trouble()->text().find("there is no room left. Make room") != std::string::npos,
                 runner->trouble()->text().c_str());
        QCOMPARE(calls(), (QStringList{"13", "14"})); // No further one would have room.
        const auto results = readResults(folder_->path(), "1.0");
        QVERIFY(results && results->size() == 1);
        QCOMPARE(QDir(folder_->filePath("runs")).entryList(QDir::Dirs | QDir::NoDotAndDotDot), QStringList{"000000"});
    }

    void aProgramThatIsNotThereIsSaid() {
        QVERIFY(QFile::remove(folder_->filePath("program")));
        campaign_.missions.front().seeds = 1;
        runAll(1, 0);
        const auto results = readResults(folder_->path(), "1.0");
        QVERIFY(results && results->size() == 1);
        QVERIFY(results->front().outcome == Outcome::Crashed);
    }

    void progressFitsItsTerminal() {
        CampaignProgress progress;
        progress.runs = 200;
        progress.done = 40;
        progress.flown = 40;
        progress.outcomes = {{Outcome::Done, 37}, {Outcome::Failed, 3}};
        progress.wall = Seconds{20.0};
        QCOMPARE(progressLine(progress),
                 std::string("[####----------------]  20 %  40 of 200 runs  3 not done  2.0 runs/s  ETA 1:20"));
        QCOMPARE(progressLine(progress, 48), std::string("[####----------------]  20 %  40 of 200 runs"));
    }

private:
    std::unique_ptr<CampaignRunner> makeRunner(int jobs, int check_every, Shard shard) {
        auto file = ShardFile::open(folder_->path(), shard);
        const auto earlier = readResults(folder_->path(), "1.0");
        if (!file || !earlier)
            return nullptr;
        return std::make_unique<CampaignRunner>(campaign_, planRuns(campaign_, {}), *earlier,
                                                RunnerOptions{.program = folder_->filePath("program"),
                                                              .folder = folder_->path(),
                                                              .shard = shard,
                                                              .jobs = jobs,
                                                              .check_every = check_every,
                                                              .version = "1.0"},
                                                *std::move(file));
    }

    /// Flies all runs and returns their runner; it has let go of its shard's file only when it is gone.
    std::unique_ptr<CampaignRunner> runAll(int jobs, int check_every, Shard shard = {}) {
        auto runner = makeRunner(jobs, check_every, shard);
        if (!runner)
            qFatal("the shard's file cannot be opened");
        QSignalSpy finished(runner.get(), &CampaignRunner::finished);
        runner->start();
        if (!finished.wait(patience_ms))
            qFatal("the campaign does not end");
        return runner;
    }

    /// Seeds that the program was called with, sorted.
    QStringList calls() const {
        QStringList seeds = QString::fromStdString(doubles::readAll(doubles::pathOf(*folder_) / "calls"))
                                .split('\n', Qt::SkipEmptyParts);
        seeds.sort();
        return seeds;
    }

    std::unique_ptr<QTemporaryDir> folder_;
    Campaign campaign_;
};

USAR_TEST(tst_CampaignRunner)

} // namespace tst_campaign_runner

#include "tst_campaign_runner.moc"
