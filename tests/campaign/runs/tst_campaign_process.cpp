#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "core/campaign/runs/campaign_process.h"
#include "tests/doubles/test_files.h"
#include "tests/suite/signaling.h"
#include "tests/suite/suite.h"

namespace tst_campaign_process {

using namespace usar;
using namespace usar::campaign;

namespace {

constexpr int patience_ms = 20000;

} // namespace

/// However a campaign's process ends, one clear sentence says so, or none where all is well.
class tst_CampaignProcess : public QObject {
    Q_OBJECT
private slots:
    void init() { folder_ = std::make_unique<QTemporaryDir>(); }

    void everyEndHasItsOwnSentence_data() {
        QTest::addColumn<std::string>("program");
        QTest::addColumn<QString>("sentence");
        QTest::newRow("all is well") << std::string(R"(echo '{"complete":true}')") << "";
        QTest::newRow("some runs failed") << std::string(R"(echo '{"complete":true}'; exit 1)") << "";
        QTest::newRow("bad input") << std::string(R"(echo '{"reason":"c.json:3:5: it is wrong"}'; exit 2)")
                                   << "c.json:3:5: it is wrong";
        QTest::newRow("killed") << std::string("kill -9 $$") << "Something ended the campaign's program (Killed).";
        QTest::newRow("no result") << std::string("exit 127") << "ended without a result (exit code 127)";
    }

    void everyEndHasItsOwnSentence() {
        QFETCH(std::string, program);
        QFETCH(QString, sentence);
        const QString said = runToItsEnd(madeOf(program));
        if (sentence.isEmpty())
            QCOMPARE(said, QString());
        else
            QVERIFY2(said.contains(sentence), qPrintable(said));
    }

    void aProgramThatIsMissingIsNamed() {
        const QString path = folder_->filePath("missing");
        const QString said = runToItsEnd(path);
        QVERIFY2(said.startsWith(path + ": the program cannot be started"), qPrintable(said));
    }

    void theCampaignIsAlwaysGoneOnWith() {
        const QString program = madeOf("echo \"$@\" > " + folder_->filePath("arguments").toStdString());
        runToItsEnd(program);
        QCOMPARE(doubles::readAll(doubles::pathOf(*folder_) / "arguments"),
                 std::string("campaign c.json --out results --resume --jobs 3\n"));
    }

    void whatIsStoppedOnRequestIsNoTrouble() {
        CampaignProcess process;
        QSignalSpy ended(&process, &CampaignProcess::ended);
        process.start(madeOf("exec sleep 60"), "c.json", "results", 1);
        QTRY_VERIFY_WITH_TIMEOUT(process.processId() > 0, patience_ms);
        process.stop();
        QVERIFY(ended.wait(patience_ms));
        QCOMPARE(ended.front().front().toString(), QString());
        QVERIFY(!process.running());
    }

    void theProcessEndsWithItsOwner() {
        auto process = std::make_unique<CampaignProcess>();
        process->start(madeOf("exec sleep 60"), "c.json", "results", 1);
        QTRY_VERIFY_WITH_TIMEOUT(process->processId() > 0, patience_ms);
        const qint64 id = process->processId();
        process.reset();
        QVERIFY(!test::sendSignal(id, 0));
    }

private:
    QString madeOf(const std::string& script) {
        const auto path = doubles::pathOf(*folder_) / "program";
        doubles::writeAll(path, "#!/bin/sh\n" + script + "\n");
        std::filesystem::permissions(path, std::filesystem::perms::owner_all);
        return QString::fromStdString(path);
    }

    static QString runToItsEnd(const QString& program) {
        CampaignProcess process;
        QSignalSpy ended(&process, &CampaignProcess::ended);
        process.start(program, "c.json", "results", 3);
        if (ended.isEmpty() && !ended.wait(patience_ms))
            return "nothing was said";
        return ended.front().front().toString();
    }

    std::unique_ptr<QTemporaryDir> folder_;
};

USAR_TEST(tst_CampaignProcess)

} // namespace tst_campaign_process

#include "tst_campaign_process.moc"
