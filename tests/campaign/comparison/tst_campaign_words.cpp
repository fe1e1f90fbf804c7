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
        QCOMPARE(failureCauses(runs), (std::vector<FailureCause>{{Outcome::Crashed, "Signal #", {2, 4}},
                                                                 {Outcome::Failed, "It fell at # s.", {0}},
                                                                 {Outcome::TimedOut, "It fell at # s.", {3}},
                                                                 {Outcome::Failed, "No room.", {5}}}));
        QVERIFY(failureCauses({runs[1]}).empty());
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
