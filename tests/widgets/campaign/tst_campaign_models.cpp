// What the views of a campaign show: the table of its runs, histograms, and the progress in words.
#include <QAbstractItemModelTester>
#include <QTest>

#include "tests/suite/suite.h"
#include "widgets/models/campaign/campaign_progress.h"
#include "widgets/models/campaign/run_histogram.h"
#include "widgets/models/campaign/run_table.h"

namespace tst_campaign_models {

using namespace usar::widgets;

namespace {

const std::vector<CampaignMetric> metrics{{"Duration", "s", 1}, {"Collisions", "", 0}};

CampaignRun run(int number, const QString& variant, std::optional<double> duration_s, bool done = true) {
    return {.number = number,
            .pair = number / 2,
            .mission = "quick",
            .variant = variant,
            .seed = static_cast<quint64>(10 + number / 2),
            .outcome = done ? "done" : "failed",
            .done = done,
            .reason = done ? "Well." : "It fell.",
            .figures = {duration_s, 1.0}};
}

QStringList column(const QAbstractItemModel& model, int column) {
    QStringList texts;
    for (int row = 0; row < model.rowCount(); ++row)
        texts << model.index(row, column).data().toString();
    return texts;
}

} // namespace

class tst_CampaignModels : public QObject {
    Q_OBJECT
private slots:
    void init() {
        table_ = std::make_unique<RunTable>();
        table_->begin(metrics);
        table_->append({run(10, "C++", 9.5), run(2, "POSH", 100.25, false)});
        table_->append({run(3, "C++", std::nullopt)});
    }

    void aRowSaysWhatCameOfTheRun() {
        const QAbstractItemModelTester tester(table_.get());
        QStringList heads, cells;
        for (int column = 0; column < table_->columnCount(); ++column) {
            heads << table_->headerData(column, Qt::Horizontal, Qt::DisplayRole).toString();
            cells << table_->index(1, column).data().toString();
        }
        QCOMPARE(heads, (QStringList{"Run", "Variant", "Seed", "Outcome", "Duration", "Collisions", "Reason"}));
        QCOMPARE(cells, (QStringList{"2", "POSH", "11", "failed", "100.2 s", "1", "It fell."}));
        QCOMPARE(table_->index(2, RunTable::first_metric).data().toString(), QString("–"));
        table_->append({});
        table_->begin({});
        QCOMPARE(table_->rowCount(), 0);
        QCOMPARE(table_->columnCount(), 5);
    }

    void aRunThatCannotBeRepeatedSaysSo() {
        CampaignRun odd = run(5, "C++", 1.0);
        odd.differs = true;
        table_->append({odd});
        QCOMPARE(table_->index(3, RunTable::Outcome).data().toString(), QString("done, not repeatable"));
    }

    void numbersAreSortedAsNumbers_data() {
        QTest::addColumn<int>("column");
        QTest::addColumn<QStringList>("numbers");
        QTest::newRow("run") << int(RunTable::Number) << QStringList{"2", "3", "10"};
        QTest::newRow("figure, the unknown last") << int(RunTable::first_metric) << QStringList{"10", "2", "3"};
        QTest::newRow("variant, then run") << int(RunTable::Variant) << QStringList{"3", "10", "2"};
        QTest::newRow("equal figures, then run") << RunTable::first_metric + 1 << QStringList{"2", "3", "10"};
        QTest::newRow("outcome") << int(RunTable::Outcome) << QStringList{"3", "10", "2"};
    }

    void numbersAreSortedAsNumbers() {
        QFETCH(int, column);
        RunFilter filter(table_.get());
        filter.sort(column);
        QTEST(::tst_campaign_models::column(filter, RunTable::Number), "numbers");
    }

    void filterWordsAreLookedForInTheWholeRow_data() {
        QTest::addColumn<QString>("words");
        QTest::addColumn<bool>("only_failures");
        QTest::addColumn<QStringList>("numbers");
        QTest::newRow("nothing") << "" << false << QStringList{"10", "2", "3"};
        QTest::newRow("a variant in other letters") << "posh" << false << QStringList{"2"};
        QTest::newRow("two words in any order") << "well  c++" << false << QStringList{"10", "3"};
        QTest::newRow("a seed") << "15" << false << QStringList{"10"};
        QTest::newRow("nowhere") << "lisp" << false << QStringList{};
        QTest::newRow("failures") << "" << true << QStringList{"2"};
        QTest::newRow("failures of another variant") << "C++" << true << QStringList{};
    }

    void filterWordsAreLookedForInTheWholeRow() {
        QFETCH(QString, words);
        QFETCH(bool, only_failures);
        RunFilter filter(table_.get());
        filter.setWords(words);
        filter.setOnlyFailures(only_failures);
        QTEST(column(filter, RunTable::Number), "numbers");
    }

    void rowsThatComeAreSortedIn() {
        RunFilter filter(table_.get());
        filter.sort(RunTable::Number);
        table_->append({run(1, "C++", 3.0), run(7, "C++", 3.0)});
        QCOMPARE(column(filter, RunTable::Number), (QStringList{"1", "2", "3", "7", "10"}));
    }

    void variantsShareTheBinsOfAHistogram() {
        const std::vector<CampaignRun> runs{run(0, "A", 10.0), run(1, "B", 19.9), run(2, "A", 20.0), run(3, "B", 47.0),
                                            run(4, "B", std::nullopt)};
        const RunHistogram histogram = histogramOf(runs, 0, 5);
        QCOMPARE(histogram.width, 10.0);
        QCOMPARE(histogram.from, 10.0);
        QCOMPARE(histogram.bins, 4);
        QCOMPARE(histogram.middle(0), 15.0);
        QCOMPARE(histogram.variants, (std::vector<VariantCounts>{{"A", {1, 1, 0, 0}, {0, 0, 0, 0}, 0},
                                                                 {"B", {1, 0, 0, 1}, {0, 0, 0, 0}, 1}}));
        QCOMPARE(histogram.highest(), 1);
        QVERIFY(!histogram.anyNotDone());
    }

    void whatWasNotDoneIsCountedApart() {
        const RunHistogram histogram =
            histogramOf({run(0, "A", 10.0), run(1, "A", 12.0, false), run(2, "A", 30.0, false)}, 0, 3);
        QCOMPARE(histogram.variants.front().counts, (std::vector<int>{1, 0, 0}));
        QCOMPARE(histogram.variants.front().not_done, (std::vector<int>{1, 0, 1}));
        QCOMPARE(histogram.highest(), 2);
        QVERIFY(histogram.anyNotDone());
    }

    void everyKnownRunIsCountedOnceAndBinsStayFew_data() {
        QTest::addColumn<double>("from");
        QTest::addColumn<double>("step");
        QTest::newRow("all equal") << 3.0 << 0.0;
        QTest::newRow("small numbers") << -0.001 << 0.0007;
        QTest::newRow("large numbers") << 1e6 << 12345.0;
        QTest::newRow("whole numbers") << 0.0 << 1.0;
    }

    void everyKnownRunIsCountedOnceAndBinsStayFew() {
        QFETCH(double, from);
        QFETCH(double, step);
        std::vector<CampaignRun> runs;
        for (int i = 0; i < 57; ++i)
            runs.push_back(run(i, "A", from + step * i));
        const RunHistogram histogram = histogramOf(runs, 0, 20);
        QVERIFY2(histogram.bins >= 1 && histogram.bins <= 20, qPrintable(QString::number(histogram.bins)));
        int all = 0;
        for (const int count : histogram.variants.front().counts)
            all += count;
        QCOMPARE(all, 57);
    }

    void aFigureThatNobodyKnowsHasNoBins() {
        const RunHistogram histogram = histogramOf({run(0, "A", std::nullopt)}, 0);
        QCOMPARE(histogram.bins, 0);
        QCOMPARE(histogram.highest(), 0);
        QCOMPARE(histogram.variants.front().unknown, 1);
        QCOMPARE(histogramOf({run(0, "A", 1.0)}, 7).bins, 0); // There is no such figure.
    }

    void progressIsSaidInWords_data() {
        QTest::addColumn<CampaignProgress>("progress");
        QTest::addColumn<QString>("text");
        using enum CampaignState;
        QTest::newRow("no campaign") << CampaignProgress{} << "";
        QTest::newRow("begins") << CampaignProgress{.state = Running} << "counting the runs…";
        QTest::newRow("was refused") << CampaignProgress{.state = Stopped} << "no runs";
        QTest::newRow("on its way") << CampaignProgress{.state = Running, .runs = 40, .done = 10, .rate_hz = 0.5}
                                    << "10 of 40 runs · 0.5 runs/s · 1:00 left";
        QTest::newRow("with failures")
            << CampaignProgress{.state = Running, .runs = 400, .done = 10, .failures = 3, .rate_hz = 13.0}
            << "10 of 400 runs · 3 not done · 13 runs/s · 0:30 left";
        QTest::newRow("stopped") << CampaignProgress{.state = Stopped, .runs = 40, .done = 10, .rate_hz = 0.5}
                                 << "10 of 40 runs";
        QTest::newRow("complete") << CampaignProgress{.state = Complete, .runs = 40, .done = 40, .failures = 1}
                                  << "40 of 40 runs · 1 not done";
    }

    void progressIsSaidInWords() {
        QFETCH(CampaignProgress, progress);
        QTEST(progressText(progress), "text");
    }

private:
    std::unique_ptr<RunTable> table_;
};

USAR_TEST(tst_CampaignModels)

} // namespace tst_campaign_models

#include "tst_campaign_models.moc"
