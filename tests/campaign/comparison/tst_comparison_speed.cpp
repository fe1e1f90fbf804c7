#include <QElapsedTimer>
#include <QJsonDocument>
#include <QTest>

#include "core/campaign/comparison/html_report.h"
#include "core/campaign/comparison/json_report.h"
#include "core/campaign/comparison/junit_report.h"
#include "core/campaign/comparison/text_report.h"
#include "tests/campaign/comparison/example_runs.h"
#include "tests/suite/suite.h"

namespace tst_comparison_speed {

using namespace usar::campaign;

namespace {

std::vector<RunFigures> tenThousandRuns() {
    std::vector<RunFigures> runs = usar::test::doneRuns(5000, {-6.0, 0.02, 3.0, 12.0});
    for (RunFigures& figures : runs) {
        figures.metrics["reachable_coverage_pct"] = 99.5;
        figures.mission = figures.pair % 3 == 0 ? "attic" : "quick_scan";
        if (figures.variant == "new" && figures.pair % 40 == 1) {
            figures.outcome = RunOutcome::Failed;
            figures.reason = "The battery was empty after " + std::to_string(figures.pair) + " s.";
        }
    }
    return runs;
}

} // namespace

class tst_ComparisonSpeed : public QObject {
    Q_OBJECT
private slots:
    void tenThousandRunsAreComparedAndReportedInTwoSeconds() {
        const std::vector<RunFigures> runs = tenThousandRuns();
        QElapsedTimer timer;
        timer.start();
        const Comparison comparison = compare(runs, "old", "new").value();
        const qint64 compared_ms = timer.elapsed();
        const Report report{comparison, runs, "ten thousand", {}};
        const QByteArray page = htmlReport(report);
        const qsizetype size = page.size() + textReport(comparison).size() + junitReport(runs, "ten thousand").size() +
                               QJsonDocument(jsonReport(report)).toJson().size();
        qInfo("compared in %lld ms, compared and reported in %lld ms, %lld bytes", compared_ms, timer.elapsed(),
              static_cast<long long>(size));
        QVERIFY2(timer.elapsed() < 2000, QByteArray::number(timer.elapsed()));
        QVERIFY2(page.size() < 500'000, QByteArray::number(page.size())); // a page that a browser scrolls smoothly
    }
};

USAR_TEST(tst_ComparisonSpeed)

} // namespace tst_comparison_speed

#include "tst_comparison_speed.moc"
