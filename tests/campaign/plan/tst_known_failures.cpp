#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "core/campaign/plan/campaign.h"
#include "tests/doubles/test_files.h"
#include "tests/suite/suite.h"

namespace tst_known_failures {

using namespace usar;
using namespace usar::campaign;

namespace {

const QByteArray campaign_text = R"({ "name": "A", "missions": ["small.json"], "again": "again.jsonl" })";

} // namespace

class tst_KnownFailures : public QObject {
    Q_OBJECT
private slots:
    void whatIsAddedIsReadOnce() {
        const QTemporaryDir folder;
        const QString path = folder.filePath("again.jsonl");
        QVERIFY(readKnownFailures(path).value().empty());
        const KnownFailure vanished{"small", "C++", 7, {"vanish from=3.0"}, {"world=town"}, "It ended as crashed: no."};
        const KnownFailure cut{"small", "POSH", 8, {}, {}, "The reason is no sentence: \"\"."};
        QVERIFY(addKnownFailures(path, {vanished}));
        QVERIFY(addKnownFailures(path, {vanished, cut}));
        QVERIFY(readKnownFailures(path).value() == (std::vector<KnownFailure>{vanished, cut}));
    }

    void aLastLineWithoutItsEndIsEnded() {
        const QTemporaryDir folder;
        const QString path = folder.filePath("again.jsonl");
        doubles::writeAll(doubles::pathOf(folder) / "again.jsonl",
                          R"({"mission": "small", "variant": "C++", "seed": 1})");
        const KnownFailure twice{"small", "C++", 2, {}, {}, {}};
        QVERIFY(addKnownFailures(path, {twice, twice}));
        const auto read = readKnownFailures(path);
        QVERIFY2(read, read ? "" : read.error().text().c_str());
        QCOMPARE(read->size(), std::size_t(2));
        QVERIFY(read->back() == twice);
    }

    void aCampaignReadsThem() {
        const QTemporaryDir folder;
        const QString path = folder.filePath("again.jsonl");
        const KnownFailure known{"small", "as written", 7, {"vanish from=3.0"}, {}, {}};
        QVERIFY(addKnownFailures(path, {known}));
        const auto campaign = readCampaign(campaign_text, folder.filePath("c.json"));
        QVERIFY2(campaign, campaign ? "" : campaign.error().text().c_str());
        QVERIFY(campaign->again == std::vector<KnownFailure>{known});
    }

    void whatCannotBeFlownIsNamed_data() {
        QTest::addColumn<QByteArray>("lines");
        QTest::addColumn<QByteArray>("words");
        const QByteArray well = R"({"mission": "small", "variant": "as written", "seed": 1})"
                                "\n";
        QTest::newRow("no JSON") << well + "{\n" << QByteArray("again.jsonl:2: this line is no known failure");
        QTest::newRow("no seed") << QByteArray(R"({"mission": "small", "variant": "as written"})")
                                 << QByteArray("again.jsonl:1: this line");
        QTest::newRow("another mission") << QByteArray(R"({"mission": "large", "variant": "as written", "seed": 1})")
                                         << QByteArray("a mission that the campaign has not: large");
        QTest::newRow("another variant") << QByteArray(R"({"mission": "small", "variant": "fast", "seed": 1})")
                                         << QByteArray("a variant that the campaign has not: fast");
    }

    void whatCannotBeFlownIsNamed() {
        QFETCH(QByteArray, lines);
        QFETCH(QByteArray, words);
        const QTemporaryDir folder;
        doubles::writeAll(doubles::pathOf(folder) / "again.jsonl", lines.toStdString());
        const auto campaign = readCampaign(campaign_text, folder.filePath("c.json"));
        QVERIFY(!campaign);
        QVERIFY2(QByteArray::fromStdString(campaign.error().text()).contains(words), campaign.error().text().c_str());
    }

    void aFileThatCannotBeWrittenIsSaid() {
        const auto added = addKnownFailures("/no/such/folder/again.jsonl", {{"small", "C++", 1, {}, {}, {}}});
        QVERIFY(!added);
        QVERIFY(added.error().text().find("/no/such/folder/again.jsonl") != std::string::npos);
    }
};

USAR_TEST(tst_KnownFailures)

} // namespace tst_known_failures

#include "tst_known_failures.moc"
