#include <QJsonArray>
#include <QTest>

#include "core/campaign/runs/invariants.h"
#include "tests/suite/suite.h"

namespace tst_invariants {

using namespace usar;
using namespace usar::campaign;

namespace {

RunResult sound() {
    RunResult result;
    result.outcome = Outcome::Done;
    result.reason = "The area is scanned.";
    result.limit_s = 600.0;
    result.summary = {{"success", true}, {"duration_s", 170.0}, {"distance_m", 120.0}, {"coverage_pct", 99.5},
                      {"collisions", 0}, {"cells", 9000},       {"charges", 0},        {"reachable_coverage_pct", {}},
                      {"rmse_m", 0.8}};
    return result;
}

RunResult with(const char* key, const QJsonValue& value) {
    RunResult result = sound();
    result.summary[key] = value;
    return result;
}

RunResult ended(Outcome outcome, const char* reason, bool success = false) {
    RunResult result = with("success", success);
    result.outcome = outcome;
    result.reason = reason;
    return result;
}

} // namespace

class tst_Invariants : public QObject {
    Q_OBJECT
private slots:
    void eachThatIsBrokenIsNamed_data() {
        QTest::addColumn<RunResult>("result");
        QTest::addColumn<QString>("words"); // empty: none is broken
        QTest::newRow("all is well") << sound() << "";
        QTest::newRow("a failure is sound") << ended(Outcome::Failed, "The robot fell into the sea.") << "";
        QTest::newRow("killed from outside") << ended(Outcome::Killed, "Something ended the program.") << "";
        QTest::newRow("crashed") << ended(Outcome::Crashed, "The program crashed.") << "ended as crashed";
        QTest::newRow("timed out") << ended(Outcome::TimedOut, "It took too long.") << "ended as timed-out";
        QTest::newRow("memory") << ended(Outcome::OutOfMemory, "No memory.") << "ended as out-of-memory";
        QTest::newRow("refused") << ended(Outcome::Refused, "No such world.") << "";
        QTest::newRow("no reason") << ended(Outcome::Failed, "") << "The reason is no sentence";
        QTest::newRow("a word for a reason") << ended(Outcome::Failed, "Failed.") << "The reason is no sentence";
        QTest::newRow("no end of the reason") << ended(Outcome::Failed, "It fell") << "The reason is no sentence";
        QTest::newRow("covered too much") << with("coverage_pct", 100.1) << "coverage_pct is 100.1";
        QTest::newRow("covered less than nothing") << with("coverage_pct", -0.1) << "coverage_pct is -0.1";
        QTest::newRow("reached too much") << with("reachable_coverage_pct", 101) << "reachable_coverage_pct is 101";
        QTest::newRow("went back") << with("distance_m", -1) << "distance_m is -1";
        QTest::newRow("fewer than no collisions") << with("collisions", -1) << "collisions is -1";
        QTest::newRow("nothing touched later") << with("contacts_after_stop", 0) << "";
        QTest::newRow("nobody watched it") << with("contacts_after_stop", {}) << "";
        QTest::newRow("not at rest") << with("contacts_after_stop", 2) << "It collided 2 times after it was stopped";
        RunResult blown = with("contacts_after_stop", 1);
        blown.summary["faults"] = QJsonArray{"31.2 s: fault begins: wind speed=5.116 from=31.2"};
        QTest::newRow("blown into something") << blown << "";
        blown.summary["faults"] = QJsonArray{"31.2 s: fault begins: sensor_freeze from=31.2"};
        QTest::newRow("not blown") << blown << "It collided 1 times after it was stopped";
        QTest::newRow("beyond its limit") << with("duration_s", 602) << "It flew for 602 s";
        QTest::newRow("just at its limit") << with("duration_s", 600.2) << "";
        QTest::newRow("no success, but code 0") << with("success", false) << "disagree";
        QTest::newRow("success, but code 1") << ended(Outcome::Failed, "It fell down.", true) << "disagree";
        QTest::newRow("success in no time") << with("duration_s", 0) << "of no duration";
        RunResult twice = sound();
        twice.differences = QStringList{};
        QTest::newRow("equal when flown again") << twice << "";
        twice.differences = QStringList{"cells", "rmse_m"};
        QTest::newRow("different when flown again") << twice << "flown again (cells, rmse_m)";
    }

    void eachThatIsBrokenIsNamed() {
        QFETCH(RunResult, result);
        QFETCH(QString, words);
        const QString broken = brokenInvariants(result).join(' ');
        QVERIFY2(words.isEmpty() ? broken.isEmpty() : broken.contains(words), qPrintable(broken));
    }
};

USAR_TEST(tst_Invariants)

} // namespace tst_invariants

#include "tst_invariants.moc"
