#include <QJsonArray>
#include <QSet>
#include <QTemporaryDir>
#include <QTest>

#include "core/campaign/comparison/campaign_figures.h"
#include "core/campaign/comparison/compare_options.h"
#include "core/campaign/plan/manifest.h"
#include "core/campaign/runs/shard_file.h"
#include "tests/doubles/test_files.h"
#include "tests/suite/suite.h"

namespace tst_campaign_figures {

using namespace usar;
using namespace usar::campaign;

namespace {

RunResult resultOf(int number, const std::string& variant, std::uint64_t seed) {
    RunResult result;
    result.number = number;
    result.pair = number / 2;
    result.mission = "quick";
    result.variant = variant;
    result.seed = seed;
    result.version = "1.0";
    result.command = "usar-mission run quick.json";
    result.limit_s = 60.0;
    result.summary = {{"duration_s", 50.5}, {"rmse_m", QJsonValue::Null}, {"collisions", 0}, {"cpu_s", 1.25}};
    return result;
}

/// Writes the folder of a campaign of two runs.
void writeCampaign(const QString& folder, std::uint64_t seed) {
    Campaign campaign;
    campaign.name = "Trial";
    campaign.missions = {{"/m/quick.json", seed, 1, {}, {}}};
    campaign.variants = {{"one", {}, {}, {}}, {"two", {}, {}, {}}};
    const Manifest manifest{"Trial",   "1.0",          {{"world", "town", "abc"}},
                            {"quick"}, {"one", "two"}, planRuns(campaign, {})};
    auto kept = keepManifest(toText(manifest, campaign), folder);
    auto file = ShardFile::open(folder, {});
    if (!kept || !file || !file->append(resultOf(0, "one", seed)) || !file->append(resultOf(1, "two", seed)))
        qFatal("the campaign cannot be written");
}

} // namespace

class tst_CampaignFigures : public QObject {
    Q_OBJECT
private slots:
    void init() { folder_ = std::make_unique<QTemporaryDir>(); }

    /// The folder was copied from another machine after the campaign, with the files that the results name.
    void aKeptPictureIsFoundWhereTheFolderIsNow() {
        writeCampaign(folder_->filePath("a"), 7);
        RunResult with_files = resultOf(2, "one", 7);
        with_files.summary["files"] =
            QJsonArray{"/elsewhere/runs/000002/scan_height.png", "/elsewhere/runs/000002/scan_picture.png"};
        QVERIFY(ShardFile::open(folder_->filePath("a"), {})->append(with_files));
        const auto figures = readCampaigns({folder_->filePath("a")});
        QVERIFY2(figures, figures ? "" : figures.error().text().c_str());
        QCOMPARE(figures->runs.front().picture, std::string());
        QCOMPARE(QString::fromStdString(figures->runs.back().picture),
                 folder_->filePath("a/runs/000002/scan_picture.png"));
    }

    void whatIsNotFlownYetIsCounted() {
        writeCampaign(folder_->filePath("a"), 7);
        auto figures = readCampaigns({folder_->filePath("a")});
        QVERIFY(figures);
        QCOMPARE(figures->planned, std::size_t(2));
        QCOMPARE(missingRuns(*figures), QString());
        figures->runs.pop_back();
        QCOMPARE(missingRuns(*figures), QString("1 of 2 runs has no result yet."));
    }

    void aCampaignIsReadWithItsFacts() {
        writeCampaign(folder_->filePath("a"), 7);
        const auto figures = readCampaigns({folder_->filePath("a")});
        QVERIFY2(figures, figures ? "" : figures.error().text().c_str());
        QCOMPARE(figures->title, std::string("Trial"));
        QVERIFY((figures->variants == std::vector<std::string>{"one", "two"}));
        QCOMPARE(figures->runs.size(), std::size_t(2));
        const RunFigures& run = figures->runs.back();
        QCOMPARE(run.variant, std::string("two"));
        QVERIFY(run.metrics.at("duration_s") == 50.5 && run.metrics.at("collisions") == 0.0);
        QVERIFY(!run.metrics.at("rmse_m") && !run.metrics.at("coverage_pct"));
        QCOMPARE(run.time_limit_s, std::optional(60.0));
        const std::vector<std::pair<std::string, std::string>> facts{
            {"version", "1.0"}, {"runs", "2 of 2"}, {"processor time", "2.5 s"}, {"world town", "abc"}};
        QVERIFY(figures->facts == facts);
    }

    void variantsOfTwoCampaignsAreToldApart_data() {
        QTest::addColumn<QString>("first");
        QTest::addColumn<QString>("second");
        QTest::addColumn<QStringList>("labels");
        QTest::newRow("other names") << "a"
                                     << "b" << QStringList{"a", "b"};
        QTest::newRow("the same name in other folders") << "old/results"
                                                        << "new/results/" << QStringList{"old/results", "new/results"};
        QTest::newRow("one in the other") << "old"
                                          << "old/old" << QStringList{"/old", "old/old"};
    }
    void variantsOfTwoCampaignsAreToldApart() {
        QFETCH(QString, first);
        QFETCH(QString, second);
        QFETCH(QStringList, labels);
        writeCampaign(folder_->filePath(first), 7);
        writeCampaign(folder_->filePath(second), 7);
        const auto figures = readCampaigns({folder_->filePath(first), folder_->filePath(second)});
        QVERIFY(figures);
        QStringList variants;
        for (const std::string& variant : figures->variants)
            variants << QString::fromStdString(variant);
        QCOMPARE(variants.size(), 4);
        QCOMPARE(QSet<QString>(variants.begin(), variants.end()).size(), 4);
        for (int i = 0; i < 4; ++i) {
            QVERIFY2(variants[i].startsWith(i % 2 == 0 ? "one (" : "two ("), qPrintable(variants[i]));
            QVERIFY2(variants[i].endsWith(labels[i / 2] + ')'), qPrintable(variants[i]));
        }
        QCOMPARE(figures->runs[2].variant, figures->variants[2]);
    }

    void aCampaignIsNotComparedWithItself() {
        writeCampaign(folder_->filePath("a"), 7);
        const auto figures = readCampaigns({folder_->filePath("a"), folder_->filePath("b/../a")});
        QVERIFY(!figures);
        QVERIFY2(figures.error().what.find("given twice") != std::string::npos, figures.error().text().c_str());
    }

    void otherSeedsAreNotPaired() {
        writeCampaign(folder_->filePath("a"), 7);
        writeCampaign(folder_->filePath("b"), 8);
        const auto figures = readCampaigns({folder_->filePath("a"), folder_->filePath("b")});
        QVERIFY(!figures);
        QVERIFY2(figures.error().what.find("quick with seed 7 in one and quick with seed 8") != std::string::npos,
                 figures.error().text().c_str());
    }

    void whatIsNoCampaignIsNamed() {
        QVERIFY(!readCampaigns({folder_->filePath("none")}));
        doubles::writeAll(doubles::pathOf(*folder_) / manifest_file, "{}\n");
        const auto no_manifest = readCampaigns({folder_->path()});
        QVERIFY(!no_manifest && no_manifest.error().where.ends_with("manifest.jsonl:1"));
        doubles::writeAll(doubles::pathOf(*folder_) / manifest_file, "{\"variants\": []}\n");
        const auto no_results = readCampaigns({folder_->path()});
        QVERIFY(!no_results && no_results.error().what.find("no results yet") != std::string::npos);
    }

    void candidatesAreTheOthers_data() {
        QTest::addColumn<QString>("baseline");
        QTest::addColumn<int>("of_first");
        QTest::addColumn<QStringList>("candidates");
        QTest::newRow("one campaign") << "a" << 4 << QStringList{"b", "c", "none"};
        QTest::newRow("one campaign, another baseline") << "b" << 4 << QStringList{"a", "c", "none"};
        QTest::newRow("the first of two") << "a" << 2 << QStringList{"c", "none"};
        QTest::newRow("the second of two") << "c" << 2 << QStringList{"a", "b"};
    }
    void candidatesAreTheOthers() {
        QFETCH(QString, baseline);
        QFETCH(int, of_first);
        CampaignFigures figures;
        figures.variants = {"a", "b", "c", "none"};
        figures.of_first = static_cast<std::size_t>(of_first);
        for (const char* variant : {"a", "b", "c"}) {
            RunFigures run;
            run.variant = variant;
            figures.runs.push_back(run);
        }
        QStringList found;
        for (const Candidate& one : candidatesFor(baseline.toStdString(), figures)) {
            found << QString::fromStdString(one.variant);
            QCOMPARE(one.trouble.has_value(), one.variant == "none");
        }
        QTEST(found, "candidates");
    }

    void readsWhatIsTyped() {
        const auto options = readCompareOptions({"compare", "a", "b", "--html", "h", "--junit", "j", "--curve", "c",
                                                 "--json", "--baseline", "x", "--candidate", "y"});
        QVERIFY(options && (*options == CompareOptions{{"a", "b"}, "x", "y", "h", "j", "c", true}));
        for (const QStringList& wrong : {QStringList{}, {"a", "b", "c"}, {"a", "--jsn"}}) {
            const auto refused = readCompareOptions(QStringList{"compare"} + wrong);
            QVERIFY(!refused && refused.error().text().find("usar-mission compare DIR") != std::string::npos);
        }
    }

private:
    std::unique_ptr<QTemporaryDir> folder_;
};

USAR_TEST(tst_CampaignFigures)

} // namespace tst_campaign_figures

#include "tst_campaign_figures.moc"
