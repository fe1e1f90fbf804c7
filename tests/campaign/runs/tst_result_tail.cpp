#include <QTemporaryDir>
#include <QTest>

#include "core/campaign/runs/result_tail.h"
#include "tests/doubles/test_files.h"
#include "tests/suite/suite.h"

namespace tst_result_tail {

using namespace usar;
using namespace usar::campaign;

namespace {

std::string lineOf(int number) {
    RunResult result;
    result.number = number;
    result.pair = number;
    return toLine(result).toStdString();
}

} // namespace

/// Results are followed while somebody else writes them.
class tst_ResultTail : public QObject {
    Q_OBJECT
private slots:
    void init() { folder_ = std::make_unique<QTemporaryDir>(); }

    void aFolderWithoutResultsHasNone() {
        QVERIFY(ResultTail(folder_->filePath("none")).take(10)->empty());
        QVERIFY(ResultTail(folder_->path()).take(10)->empty());
    }

    void eachResultComesOnceAndATornLineWaits() {
        ResultTail tail(folder_->path());
        const std::string torn = lineOf(2);
        write(0, lineOf(0) + lineOf(1) + torn.substr(0, 20));
        QCOMPARE(numbers(tail), (QList<int>{0, 1}));
        QCOMPARE(numbers(tail), QList<int>());
        write(0, lineOf(0) + lineOf(1) + torn);
        write(1, lineOf(7));
        QCOMPARE(numbers(tail), (QList<int>{2, 7}));
        write(1, lineOf(7) + lineOf(2)); // Two programs may have flown one run; the first result counts.
        QCOMPARE(numbers(tail), QList<int>());
    }

    void noMoreAreTakenThanAskedFor() {
        ResultTail tail(folder_->path());
        write(0, lineOf(0) + lineOf(1) + lineOf(2));
        write(1, lineOf(3));
        QCOMPARE(numbers(tail, 2), (QList<int>{0, 1}));
        QCOMPARE(numbers(tail, 2), (QList<int>{2, 3}));
    }

    void aLineThatIsNoResultIsNamed() {
        ResultTail tail(folder_->path());
        write(0, lineOf(0));
        QCOMPARE(numbers(tail), QList<int>{0});
        write(0, lineOf(0) + "{}\n");
        const auto read = tail.take(10);
        QVERIFY(!read);
        QVERIFY2(read.error().where.ends_with("shard-000.jsonl:2"), read.error().where.c_str());
    }

    void resultsBeforeALineThatIsNoneAreNotLost() {
        ResultTail tail(folder_->path());
        write(0, lineOf(0) + lineOf(1) + "{}\n" + lineOf(2));
        write(1, lineOf(7));
        QCOMPARE(numbers(tail), (QList<int>{0, 1, 7}));
        const auto read = tail.take(10);
        QVERIFY(!read);
        QVERIFY2(read.error().where.ends_with("shard-000.jsonl:3"), read.error().where.c_str());
    }

private:
    void write(int shard, const std::string& text) {
        doubles::writeAll(doubles::pathOf(*folder_) / ("shard-00" + std::to_string(shard) + ".jsonl"), text);
    }

    static QList<int> numbers(ResultTail& tail, std::size_t most = 100) {
        QList<int> numbers;
        const auto results = tail.take(most);
        for (const RunResult& result : results.value())
            numbers << result.number;
        return numbers;
    }

    std::unique_ptr<QTemporaryDir> folder_;
};

USAR_TEST(tst_ResultTail)

} // namespace tst_result_tail

#include "tst_result_tail.moc"
