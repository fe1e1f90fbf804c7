#include <ctime>

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
            figures.outcome = Outcome::Failed;
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
        // Processor time, because it is the same on a machine that has other things to do.
        const std::clock_t start = std::clock();
        const auto spent_ms = [start] { return 1000 * (std::clock() - start) / CLOCKS_PER_SEC; };
        const Comparison comparison = compare(runs, "old", "new").value();
        const auto compared_ms = spent_ms();
        const Report report{comparison, runs, "ten thousand", {}};
        const QByteArray page = htmlReport(report);
        const qsizetype size = page.size() + textReport(comparison).size() + junitReport(runs, "ten thousand").size() +
                               QJsonDocument(jsonReport(report)).toJson().size();
        const auto all_ms = spent_ms();
        qInfo("compared in %ld ms, compared and reported in %ld ms, %lld bytes", compared_ms, all_ms,
              static_cast<long long>(size));
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
        QVERIFY2(all_ms < 2000, QByteArray::number(static_cast<qint64>(all_ms)));
#endif
        QVERIFY2(page.size() < 500'000, QByteArray::number(page.size())); // a page that a browser scrolls smoothly
    }
};

USAR_TEST(tst_ComparisonSpeed)

} // namespace tst_comparison_speed

#include "tst_comparison_speed.moc"
