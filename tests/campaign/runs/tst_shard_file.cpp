#include <cerrno>
#include <csignal>
#include <cstring>

#include <sys/resource.h>

#include <QFileInfo>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include "core/campaign/runs/shard_file.h"
#include "tests/doubles/test_files.h"
#include "tests/suite/suite.h"

namespace tst_shard_file {

using namespace usar;
using namespace usar::campaign;

namespace {

RunResult resultOf(int number) {
    RunResult result;
    result.number = number;
    result.pair = number / 2;
    result.mission = "m";
    result.variant = "v";
    result.seed = 9007199254740991u;
    result.outcome = Outcome::Failed;
    result.reason = "It \"fell\".\nTwice";
    result.wall_s = 1.5;
    result.version = "1.0";
    result.command = "usar-mission run m";
    result.limit_s = 7200.0;
    result.summary = {{"success", false}, {"rmse_m", 0.25}};
    result.differences = QStringList{"rmse_m"};
    return result;
}

} // namespace

class tst_ShardFile : public QObject {
    Q_OBJECT
private slots:
    void init() { folder_ = std::make_unique<QTemporaryDir>(); }

    void aResultIsReadAsItWasWritten() {
        const QByteArray line = toLine(resultOf(4));
        QCOMPARE(line.count('\n'), 1);
        const auto read = readResultLine(line);
        QVERIFY(read);
        QCOMPARE(toLine(*read), line);
        QCOMPARE(read->reason, resultOf(4).reason);
        QCOMPARE(read->seed, resultOf(4).seed);
        QCOMPARE(read->limit_s, std::optional(7200.0));
        QVERIFY(read->summary == resultOf(4).summary && read->differences == resultOf(4).differences);
    }

    void aHeadIsAllButTheSummary_data() {
        QTest::addColumn<QString>("reason");
        QTest::addColumn<bool>("flew");
        QTest::newRow("usual") << QString("It fell.") << true;
        QTest::newRow("a reason like the file") << QString("It said {\"a\":1,\"summary\":{\"success\":true}}.") << true;
        QTest::newRow("without a summary") << QString("It crashed.") << false;
    }

    void aHeadIsAllButTheSummary() {
        QFETCH(QString, reason);
        QFETCH(bool, flew);
        RunResult result = resultOf(4);
        result.reason = reason.toStdString();
        result.broken = QStringList{"Its \"summary\":{} is odd."};
        if (!flew)
            result.summary = {};
        const QByteArray line = toLine(result);
        const auto head = readResultLine(line, ResultPart::Head);
        const auto whole = readResultLine(line);
        QVERIFY(head && whole);
        QVERIFY(head->summary.isEmpty() && whole->summary == result.summary);
        result.summary = {};
        QCOMPARE(toLine(*head), toLine(result));
        QCOMPARE(whole->broken, result.broken);
    }

    void outcomesHaveWordsOfTheirOwn() {
        for (int i = 0; i <= static_cast<int>(Outcome::OutOfMemory); ++i)
            QVERIFY(outcomeFrom(wordOf(static_cast<Outcome>(i))) == static_cast<Outcome>(i));
        QVERIFY(!outcomeFrom("well"));
    }

    void twiceFlownRunsAreComparedButForWallTimeAndFiles() {
        const QJsonObject one{{"rmse_m", 1}, {"wall_s", 1}, {"cpu_s", 1}, {"speed_x", 1}, {"files", "a"}};
        QJsonObject two{{"rmse_m", 1}, {"wall_s", 2}, {"cpu_s", 2}, {"speed_x", 2}, {"files", "b"}};
        QVERIFY(differencesOf(one, two).isEmpty());
        two["rmse_m"] = 2;
        two["new"] = QJsonValue::Null;
        QCOMPARE(differencesOf(one, two), (QStringList{"new", "rmse_m"}));
    }

    void everyPrefixOfAFileIsReadUpToItsLastWholeLine() {
        QByteArray whole;
        for (int i = 0; i < 3; ++i)
            whole += toLine(resultOf(i));
        for (qsizetype size = 0; size <= whole.size(); size += 7) {
            write("shard-000.jsonl", whole.left(size));
            const auto read = readResults(folder_->path(), "1.0");
            QVERIFY(read);
            QCOMPARE(static_cast<qsizetype>(read->size()), whole.left(size).count('\n'));
            {
                auto file = ShardFile::open(folder_->path(), {});
                QVERIFY(file);
                QVERIFY(file->append(resultOf(7)));
            }
            const auto again = readResults(folder_->path(), "1.0");
            QVERIFY(again);
            QCOMPARE(again->size(), read->size() + 1);
            QCOMPARE(again->back().number, 7);
        }
    }

    void aRunThatIsThereTwiceCountsOnce() {
        write("shard-000.jsonl", toLine(resultOf(5)) + toLine(resultOf(1)));
        RunResult later = resultOf(5);
        later.outcome = Outcome::Done;
        write("shard-001.jsonl", toLine(later));
        const auto read = readResults(folder_->path(), "1.0");
        QVERIFY(read);
        QCOMPARE(read->size(), std::size_t(2));
        QCOMPARE(read->front().number, 1);
        QVERIFY(read->back().outcome == Outcome::Failed);
    }

    void wrongLinesAreNamed_data() {
        QTest::addColumn<QByteArray>("line");
        QTest::addColumn<QString>("words");
        RunResult old = resultOf(1);
        old.version = "0.9";
        QTest::newRow("another version") << toLine(old) << "version 0.9";
        QTest::newRow("no JSON") << QByteArray("{\"run\": 1,\n") << "not JSON";
        QTest::newRow("a summary that was cut off") << toLine(resultOf(1)).chopped(10) + '\n' << "not JSON";
        QTest::newRow("no result") << QByteArray("{\"run\": 1}\n") << "no result";
        QTest::newRow("a number below 0")
            << QByteArray("{\"run\": -1, \"pair\": 0, \"outcome\": \"done\"}\n") << "no result";
    }

    void wrongLinesAreNamed() {
        QFETCH(QByteArray, line);
        QFETCH(QString, words);
        write("shard-002.jsonl", toLine(resultOf(0)) + line);
        for (const ResultPart part : {ResultPart::Whole, ResultPart::Head}) {
            const auto read = readResults(folder_->path(), "1.0", part);
            QVERIFY(!read);
            const QString said = QString::fromStdString(read.error().text());
            QVERIFY2(said.contains(words) && said.contains("shard-002.jsonl:2"), qPrintable(said));
        }
    }

    void onlyOneWritesAShard() {
        const auto first = ShardFile::open(folder_->path(), {0, 2});
        QVERIFY(first);
        const auto second = ShardFile::open(folder_->path(), {0, 2});
        QVERIFY(!second && second.error().what.find("another program") != std::string::npos);
        QVERIFY(ShardFile::open(folder_->path(), {1, 2}));
    }

    void partsThatWouldOverlapAreRefused_data() {
        QTest::addColumn<int>("first");
        QTest::addColumn<int>("second");
        QTest::addColumn<QString>("words");
        QTest::newRow("the whole and a part")
            << 1 << 2 << "flies this campaign undivided, and this one would fly it in 2";
        QTest::newRow("a part and the whole") << 2 << 1 << "flies this campaign in 2 parts";
        QTest::newRow("two divisions") << 4 << 2 << "in 4 parts, and this one would fly it in 2 parts";
    }

    void partsThatWouldOverlapAreRefused() {
        QFETCH(int, first);
        QFETCH(int, second);
        QFETCH(QString, words);
        auto one = ShardFile::open(folder_->path(), {first - 1, first});
        QVERIFY(one);
        const Shard overlapping{first == 1 ? 1 : 0, second};
        const auto other = ShardFile::open(folder_->path(), overlapping);
        QVERIFY(!other);
        const QString said = QString::fromStdString(other.error().text());
        QVERIFY2(said.contains(words), qPrintable(said));
        one = tl::unexpected(Error{});
        QVERIFY(ShardFile::open(folder_->path(), overlapping)); // Afterwards it may be divided in another way.
    }

    void aFullDiskIsSaid() {
        const QString path = folder_->filePath("shard-000.jsonl");
        QVERIFY(QFile::link("/dev/full", path));
        QTest::ignoreMessage(QtWarningMsg, QRegularExpression("sequential device"));
        auto file = ShardFile::open(folder_->path(), {});
        QVERIFY2(file, file ? "" : file.error().text().c_str());
        const auto written = file->append(resultOf(1));
        QVERIFY(!written && written.error().text().find("--resume") != std::string::npos);
    }

    /// A limit on the size of files ends a write in the middle of a line, as a disk does that fills up.
    void aLineThatFitsInPartIsToldAndDroppedLater() {
        auto file = ShardFile::open(folder_->path(), {});
        QVERIFY(file && file->append(resultOf(1)));
        const qint64 whole = QFileInfo(folder_->filePath("shard-000.jsonl")).size();
        std::signal(SIGXFSZ, SIG_IGN);
        rlimit before{};
        getrlimit(RLIMIT_FSIZE, &before);
        const rlimit narrow{static_cast<rlim_t>(whole + 10), before.rlim_max};
        setrlimit(RLIMIT_FSIZE, &narrow);
        const auto written = file->append(resultOf(2));
        setrlimit(RLIMIT_FSIZE, &before);
        QVERIFY(!written);
        const QString said = QString::fromStdString(written.error().text());
        QVERIFY2(said.contains(std::strerror(EFBIG)), qPrintable(said));
        file = tl::unexpected(Error{}); // It lets go of its file.
        QVERIFY(ShardFile::open(folder_->path(), {}));
        QCOMPARE(QFileInfo(folder_->filePath("shard-000.jsonl")).size(), whole);
    }

private:
    void write(const char* name, const QByteArray& bytes) const {
        doubles::writeAll(doubles::pathOf(*folder_) / name, bytes.toStdString());
    }

    std::unique_ptr<QTemporaryDir> folder_;
};

USAR_TEST(tst_ShardFile)

} // namespace tst_shard_file

#include "tst_shard_file.moc"
