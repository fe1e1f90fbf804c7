// What is said of a plan after it ran.
#include <QTest>

#include "core/posh/trace/run_report.h"
#include "tests/posh/trial.h"
#include "tests/suite/suite.h"

namespace tst_run_report {

using namespace usar;
using namespace usar::posh;

namespace {

/// A run with statistics: `before` each cycle may change what senses and acts answer.
template <class Before>
RunStatistics statisticsOf(const std::string& plan, int cycles, Before&& before) {
    TrialHost host;
    RunStatistics statistics;
    Engine engine(host, programOf(plan));
    engine.watch(&statistics);
    for (int cycle = 1; cycle <= cycles; ++cycle) {
        before(host, cycle);
        engine.cycle(Milliseconds(200 * cycle));
    }
    engine.watch(nullptr);
    return statistics;
}

QStringList remarksOn(const RunStatistics& statistics) {
    QStringList remarks;
    for (const RunFinding& finding : reportOn(statistics))
        remarks << QString::fromStdString(std::string(toText(finding.remark)) + " " +
                                          pathOf(*statistics.program(), finding.place));
    return remarks;
}

} // namespace

class tst_RunReport : public QObject {
    Q_OBJECT
private slots:
    void saysWhatNeverHappened();
    void saysWhatWasNeverOtherwise();
    void saysWhichDrivesCannotSettle();
    void saysWhatStarvesAndWhatSpins();
    void saysNothingOfAPlanThatNeverRan();
    void countsWhatActsTook();
    void runsAddUp();
};

void tst_RunReport::saysWhatNeverHappened() {
    const RunStatistics statistics =
        statisticsOf("((C c (elements ((e (trigger ((far))) walk)) ((f sit)) ((g sing)))) "
                     "(C other (elements ((h swim)))) (DC d (drives ((high (trigger ((near))) other)) ((low c)))))",
                     5, [](TrialHost&, int) {});
    QCOMPARE(remarksOn(statistics),
             (QStringList{"never-selected /P:0/DC:0/DE:0", "never-true /P:0/DC:0/DE:0/S:0",
                          "never-selected /P:0/DC:0/DE:1/A:0/C:0/CE:0", "never-true /P:0/DC:0/DE:1/A:0/C:0/CE:0/S:0",
                          "never-selected /P:0/DC:0/DE:1/A:0/C:0/CE:2"}));
    QCOMPARE(reportOn(statistics).front().message, std::string("d ▸ high never started in 5 cycles"));
}

void tst_RunReport::saysWhatWasNeverOtherwise() {
    const std::string plan = "((DC d (drives ((a (trigger ((near) (succeed))) walk)))))";
    const auto near = [](TrialHost& host, int) { host.setSense("near", true); };
    QCOMPARE(remarksOn(statisticsOf(plan, 49, near)), QStringList());
    QCOMPARE(remarksOn(statisticsOf(plan, 50, near)), QStringList{"always-true /P:0/DC:0/DE:0/S:0"});
}

void tst_RunReport::saysWhichDrivesCannotSettle() {
    const std::string plan = "((DC d (drives ((a (trigger ((near))) back)) ((b go)))))";
    const auto flickers = [](TrialHost& host, int cycle) { host.setSense("near", cycle % 2 == 0); };
    const auto changes = [](TrialHost& host, int cycle) { host.setSense("near", cycle % 40 < 20); };
    QCOMPARE(remarksOn(statisticsOf(plan, 20, flickers)), QStringList{"oscillation /P:0/DC:0/DE:0"});
    QCOMPARE(remarksOn(statisticsOf(plan, 200, changes)), QStringList());
}

void tst_RunReport::saysWhatStarvesAndWhatSpins() {
    QCOMPARE(remarksOn(statisticsOf("((AP p ((near) walk)) (DC d (drives ((a p)))))", 10, [](TrialHost&, int) {})),
             (QStringList{"starving /P:0/DC:0/DE:0", "never-true /P:0/DC:0/DE:0/A:0/AP:0/A:0"}));
    QCOMPARE(remarksOn(statisticsOf("((DC d (drives ((a tick)))))", 3,
                                    [](TrialHost& host, int) { host.setResult("tick", ActResult::Finished); })),
             QStringList{"spinning /P:0/DC:0/DE:0"});
}

void tst_RunReport::saysNothingOfAPlanThatNeverRan() {
    QCOMPARE(remarksOn(statisticsOf("((DC d (drives ((a tick)))))", 0, [](TrialHost&, int) {})), QStringList());
}

void tst_RunReport::countsWhatActsTook() {
    const RunStatistics statistics = statisticsOf("((DC d (drives ((a walk)))))", 10, [](TrialHost& host, int cycle) {
        host.setResult("walk", cycle % 5 == 0 ? ActResult::Failed : ActResult::Running);
    });
    const PlaceCounts& walk = statistics.at(statistics.program()->acts.front().place);
    QCOMPARE(walk.started, std::uint64_t(2));
    QCOMPARE(walk.runs, std::uint64_t(10));
    QCOMPARE(walk.failed, std::uint64_t(2));
    QCOMPARE(walk.active_ms, std::int64_t(1800)); // until the last cycle
    QCOMPARE(statistics.at(statistics.program()->drives.front().place).active_ms, std::int64_t(1800));
    QCOMPARE(walk.last_cycle, std::uint64_t(10));
}

void tst_RunReport::runsAddUp() {
    const std::string plan = "((DC d (drives ((a (trigger ((near))) walk)) ((b sit)))))";
    RunStatistics all = statisticsOf(plan, 5, [](TrialHost&, int) {});
    QVERIFY(all.add(statisticsOf(plan, 7, [](TrialHost& host, int) { host.setSense("near", true); })));
    QCOMPARE(all.cycles(), std::uint64_t(12));
    QCOMPARE(remarksOn(all), QStringList());
    QVERIFY(!all.add(statisticsOf("((DC d (drives ((c walk)))))", 1, [](TrialHost&, int) {})));
    QCOMPARE(all.cycles(), std::uint64_t(12));
}

USAR_TEST(tst_RunReport)

} // namespace tst_run_report

#include "tst_run_report.moc"
