#include <QTemporaryDir>
#include <QTest>

#include "core/campaign/plan/manifest.h"
#include "tests/doubles/test_files.h"
#include "tests/suite/suite.h"

namespace tst_manifest {

using namespace usar;
using namespace usar::campaign;

namespace {

Campaign oneMission() {
    Campaign campaign;
    campaign.name = "One";
    campaign.missions = {{"/m/a.json", 1, 2, {}, {}}};
    campaign.variants = {{"plain", {}, {}, {}}};
    return campaign;
}

QByteArray textWith(const QByteArray& hash, const Campaign& campaign = oneMission()) {
    const Manifest manifest{"One", "1.0", {{"plan", "p.lap", hash}}, {"a"}, {"plain"}, planRuns(campaign, {})};
    return toText(manifest, campaign);
}

} // namespace

class tst_Manifest : public QObject {
    Q_OBJECT
private slots:
    void init() { folder_ = std::make_unique<QTemporaryDir>(); }

    void theSameCampaignGoesOn() {
        const QString folder = folder_->filePath("new/folder");
        QVERIFY(keepManifest(textWith("aa"), folder));
        QVERIFY(keepManifest(textWith("aa"), folder));
        const std::string text = doubles::readAll((folder + '/' + manifest_file).toStdString());
        QCOMPARE(std::ranges::count(text, '\n'), 3);
    }

    void anotherOneIsRefusedAndTheDifferenceNamed() {
        QVERIFY(keepManifest(textWith("aa"), folder_->path()));
        const auto other_plan = keepManifest(textWith("bb"), folder_->path());
        QVERIFY(!other_plan);
        QVERIFY2(other_plan.error().what.find("the plan p.lap is not what it was") != std::string::npos,
                 other_plan.error().text().c_str());
        Campaign more = oneMission();
        more.missions.front().seeds = 3;
        const auto more_runs = keepManifest(textWith("aa", more), folder_->path());
        QVERIFY(!more_runs && more_runs.error().what.find("number of runs") != std::string::npos);
        Campaign windy = oneMission();
        windy.faults = {"wind"};
        QVERIFY(!keepManifest(textWith("aa", windy), folder_->path()));
        QVERIFY(keepManifest(textWith("aa"), folder_->path()));
    }

    void aFolderThatCannotBeMadeIsNamed() {
        doubles::writeAll(doubles::pathOf(*folder_) / "file", "");
        const auto kept = keepManifest(textWith("aa"), folder_->filePath("file/below"));
        QVERIFY(!kept && kept.error().where.find("file/below") != std::string::npos);
    }

    void hashesSeeContentsAndNames() {
        const auto hashOf = [&](const char* name) {
            const auto input = hashInput("world", "w", folder_->filePath(name));
            return input ? input->sha256_hex : QByteArray();
        };
        const auto path = doubles::pathOf(*folder_);
        doubles::writeAll(path / "abc", "abc"); // FIPS 180-2, example B.1
        QCOMPARE(hashOf("abc"), QByteArray("ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"));
        for (const char* name : {"one", "two", "three"})
            std::filesystem::create_directories(path / name / "below");
        doubles::writeAll(path / "one/below/x", "1");
        doubles::writeAll(path / "two/below/x", "2");
        doubles::writeAll(path / "three/below/y", "1");
        QVERIFY(hashOf("one") != hashOf("two"));
        QVERIFY(hashOf("one") != hashOf("three"));
        doubles::writeAll(path / "two/below/x", "1");
        QCOMPARE(hashOf("one"), hashOf("two"));
        QVERIFY(!hashInput("plan", "p", folder_->filePath("none")));
    }

private:
    std::unique_ptr<QTemporaryDir> folder_;
};

USAR_TEST(tst_Manifest)

} // namespace tst_manifest

#include "tst_manifest.moc"
