// What a recording that begins during a run must begin with.
#include <QTest>

#include "core/mission/session/behavior_so_far.h"
#include "core/posh/trace/trace_codec.h"
#include "tests/suite/suite.h"

namespace tst_behavior_so_far {

using namespace usar;
using namespace usar::mission;

namespace {

agent::BehaviorStatus status(const char* state) {
    agent::BehaviorStatus one;
    one.state = state;
    return one;
}

agent::PlanTrace begun(const std::string& rest) {
    return {std::string(posh::trace_codec::magic) + rest};
}

} // namespace

class tst_BehaviorSoFar : public QObject {
    Q_OBJECT
private slots:
    void onlyTheNewestOfSomeKindsCounts() {
        QVERIFY(replacesItsPredecessor(status("idle")));
        QVERIFY(replacesItsPredecessor(agent::SonarZones{}));
        QVERIFY(replacesItsPredecessor(agent::PlannedPath{}));
        QVERIFY(replacesItsPredecessor(agent::CurrentGoal{}));
        QVERIFY(!replacesItsPredecessor(agent::PoseEstimate{}));
        QVERIFY(!replacesItsPredecessor(agent::MapMark{}));
        QVERIFY(!replacesItsPredecessor(agent::ScanPlacement{}));
        QVERIFY(!replacesItsPredecessor(agent::BehaviorEvent{}));
        QVERIFY(!replacesItsPredecessor(agent::PlanTrace{}));
        QVERIFY(!replacesItsPredecessor(agent::BehaviorFinished{}));
    }

    void nothingIsKeptOfNothing() {
        BehaviorSoFar so_far;
        QVERIFY(so_far.all().empty());
        so_far.take(agent::MapMark{});
        so_far.take(agent::PoseEstimate{});
        so_far.take(agent::BehaviorEvent{Severity::Warning, "odd"});
        QVERIFY(so_far.all().empty());
    }

    void theNewestOfEachKindIsKept() {
        BehaviorSoFar so_far;
        so_far.take(status("taking off"));
        so_far.take(agent::CurrentGoal{Vec3(1, 2, 3)});
        so_far.take(agent::PlannedPath{{{0, 0}, {1, 1}}});
        so_far.take(agent::CurrentGoal{std::nullopt});
        so_far.take(status("scanning"));
        const std::vector<agent::Published> all = so_far.all();
        QCOMPARE(all.size(), std::size_t(3));
        QVERIFY(all[0] == agent::Published(status("scanning")));
        QVERIFY(all[1] == agent::Published(agent::PlannedPath{{{0, 0}, {1, 1}}}));
        QVERIFY(all[2] == agent::Published(agent::CurrentGoal{std::nullopt}));
        so_far.clear();
        QVERIFY(so_far.all().empty());
    }

    void thePiecesOfATraceAreJoinedAndComeFirst() {
        BehaviorSoFar so_far;
        so_far.take(status("scanning"));
        so_far.take(begun("first "));
        so_far.take(agent::PlanTrace{"second"});
        std::vector<agent::Published> all = so_far.all();
        QCOMPARE(all.size(), std::size_t(2));
        QVERIFY(all[0] == agent::Published(begun("first second")));
        so_far.take(begun("of another run"));
        all = so_far.all();
        QVERIFY(all[0] == agent::Published(begun("of another run")));
    }

    void aHaltIsKeptUntilThePlanGoesOn() {
        BehaviorSoFar so_far;
        so_far.take(begun(""));
        so_far.take(agent::PlanHalted{.cycle = 3, .reason = "before work"});
        so_far.take(agent::PlanHalted{.cycle = 4, .reason = "before rest"});
        const std::vector<agent::Published> all = so_far.all();
        QCOMPARE(all.size(), std::size_t(2));
        QVERIFY(all[1] == agent::Published(agent::PlanHalted{.cycle = 4, .reason = "before rest"}));
        so_far.take(agent::PlanResumed{});
        QCOMPARE(so_far.all().size(), std::size_t(1));
    }
};

USAR_TEST(tst_BehaviorSoFar)

} // namespace tst_behavior_so_far

#include "tst_behavior_so_far.moc"
