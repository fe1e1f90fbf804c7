#include <QJsonArray>
#include <QJsonObject>
#include <QTest>

#include "core/campaign/comparison/failure_causes.h"
#include "core/campaign/comparison/verdict_words.h"
#include "tests/campaign/comparison/example_runs.h"
#include "tests/suite/suite.h"

namespace tst_campaign_words {

using namespace usar::campaign;
using usar::test::Change;
using usar::test::doneRuns;

namespace {

RunResult ended(int number, Outcome outcome, const std::string& reason) {
    RunResult result;
    result.number = number;
    result.outcome = outcome;
    result.reason = reason;
    return result;
}

} // namespace

/// What a window says of a campaign: causes of failures, and verdicts.
class tst_CampaignWords : public QObject {
    Q_OBJECT
private slots:
    void runsThatFailForOneReasonAreOneCause() {
        const std::vector<RunResult> runs{
            ended(0, Outcome::Failed, "It fell at 3.5 s."), ended(1, Outcome::Done, "Well."),
            ended(2, Outcome::Crashed, "Signal 11"),        ended(3, Outcome::TimedOut, "It fell at 1 s."),
            ended(4, Outcome::Crashed, "Signal 6"),         ended(5, Outcome::Failed, "No room.")};
        QCOMPARE(failureCauses(runs), (std::vector<FailureCause>{{Outcome::Crashed, "Signal #", {2, 4}, {"", ""}},
                                                                 {Outcome::Failed, "It fell at # s.", {0}, {""}},
                                                                 {Outcome::TimedOut, "It fell at # s.", {3}, {""}},
                                                                 {Outcome::Failed, "No room.", {5}, {""}}}));
        QVERIFY(failureCauses({runs[1]}).empty());
    }

    void runsOfACauseAreGroupedByPlace() {
        std::vector<RunResult> runs;
        const auto add = [&](const QJsonArray& path, const QJsonArray& collisions) {
            runs.push_back(ended(static_cast<int>(runs.size()), Outcome::Failed, "It fell."));
            if (!path.isEmpty())
                runs.back().summary["course"] = QJsonObject{{"path", path}, {"collisions", collisions}};
        };
        const QJsonArray start{0.0, 0.0};
        add({}, {});
        add({start, QJsonArray{35.0, 5.0}}, {});
        add({start, QJsonArray{-1.0, -12.0}}, {});
        add({start, QJsonArray{90.0, 90.0}}, {QJsonArray{1.0, 1.0}, QJsonArray{-9.0, -19.0}}); // It rolled on.
        const std::vector<FailureCause> causes = failureCauses(runs);
        QCOMPARE(causes.size(), std::size_t(1));
        QCOMPARE(causes[0].indices, (std::vector<std::size_t>{2, 3, 1, 0}));
        const std::string there = "around x -5 m, y -15 m";
        QCOMPARE(causes[0].places, (std::vector<std::string>{there, there, "around x 35 m, y 5 m", ""}));
    }

    void theVariantsOfACauseAreCounted() {
        std::vector<RunResult> runs(4);
        runs[0].variant = runs[1].variant = runs[3].variant = "C++, Scan altitude 5";
        runs[2].variant = "POSH";
        QCOMPARE(QString::fromStdString(variantCounts(runs, {0, 1, 2, 3})),
                 QString::fromUtf8("3 \u00d7 C++, Scan altitude 5, 1 \u00d7 POSH"));
    }

    void aVerdictSaysTheWordAndTheNumbers() {
        const std::vector<RunFigures> runs = doneRuns(60, Change{.duration_s = -20.0});
        const std::vector<VerdictLine> lines = verdictLines(compare(runs, "old", "new").value());
        QCOMPARE(lines.front().title, QString("Success"));
        QVERIFY2(lines.front().detail.startsWith("old 60 of 60, 100.0 %, new 60 of 60, 100.0 %; in pairs 0.0 points ("),
                 qPrintable(lines.front().detail));
        const auto duration = std::ranges::find(lines, QString("Duration"), &VerdictLine::title);
        QVERIFY(duration != lines.end());
        QCOMPARE(duration->word, QString("better"));
        QVERIFY2(duration->detail.contains(" s; in pairs −") && !duration->detail.contains("would decide"),
                 qPrintable(duration->detail));
    }

    void whatIsUndecidedSaysWhatWouldDecide() {
        const std::vector<RunFigures> runs = doneRuns(12, Change{.duration_s = -2.0, .noise_s = 8.0});
        const std::vector<VerdictLine> lines = verdictLines(compare(runs, "old", "new").value());
        const auto duration = std::ranges::find(lines, QString("Duration"), &VerdictLine::title);
        QVERIFY(duration != lines.end());
        QCOMPARE(duration->word, QString("undecided"));
        QVERIFY2(duration->detail.contains("decide"), qPrintable(duration->detail));
    }
};

USAR_TEST(tst_CampaignWords)

} // namespace tst_campaign_words

#include "tst_campaign_words.moc"
