#include <algorithm>

#include <QTest>

#include "core/campaign/runs/shrinking.h"
#include "tests/suite/suite.h"

namespace tst_shrinking {

using namespace usar;
using namespace usar::campaign;

namespace {

bool has(const FaultTexts& faults, const char* one) {
    return std::ranges::find(faults, one) != faults.end();
}

} // namespace

class tst_Shrinking : public QObject {
    Q_OBJECT
private slots:
    void onlyWhatIsNeededIsLeft() {
        const auto needs_two = [](const FaultTexts& faults) { return has(faults, "b") && has(faults, "d"); };
        QVERIFY(shrunk({"a", "b", "c", "d", "e"}, needs_two) == (FaultTexts{"b", "d"}));
    }

    void whatBreaksWithoutAnyFaultNeedsNone() {
        QVERIFY(shrunk({"a", "b"}, [](const FaultTexts&) { return true; }).empty());
    }

    /// "a" can go only once "b" has gone.
    void aFaultIsTriedAgainOnceAnotherHasGone() {
        const auto still_breaks = [](const FaultTexts& faults) {
            return has(faults, "c") && (has(faults, "a") || !has(faults, "b"));
        };
        QVERIFY(shrunk({"a", "b", "c"}, still_breaks) == FaultTexts{"c"});
    }

    void itNeverAsksAboutAllOfThem() {
        int calls = 0;
        const auto still_breaks = [&](const FaultTexts& faults) {
            ++calls;
            return faults.size() == 3;
        };
        QCOMPARE(shrunk({"a", "b", "c"}, still_breaks).size(), std::size_t(3));
        QCOMPARE(calls, 3);
    }

    void aKnownFailureLeavesOutTheVariantsOwnValues() {
        Campaign campaign;
        campaign.missions = {{"/m/a.json", 1, 1, {}, {}}};
        campaign.variants = {{"high", "airrobot/cpp", {}, {"parameters.altitude_m=9"}}};
        const PlannedRun run{4, 2, 0, 0, 5, {"vanish from=3.0"}, {"world=town", "parameters.altitude_m=9"}};
        RunResult result;
        result.mission = "a";
        result.variant = "high";
        result.outcome = Outcome::Crashed;
        result.reason = "The program crashed.";
        result.broken = QStringList{"It ended as crashed: The program crashed."};
        const KnownFailure expected{
            "a", "high", 5, {"vanish from=3.0"}, {"world=town"}, "It ended as crashed: The program crashed."};
        QVERIFY(knownFailure(campaign, run, result) == expected);
    }
};

USAR_TEST(tst_Shrinking)

} // namespace tst_shrinking

#include "tst_shrinking.moc"
