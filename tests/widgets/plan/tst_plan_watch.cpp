// The plan of a robot at the moments of its run, live and in a replay that is wound back.
#include <QTest>

#include "core/posh/run/engine.h"
#include "core/posh/trace/trace_encoder.h"
#include "tests/doubles/stub_host.h"
#include "tests/suite/suite.h"
#include "widgets/models/plan/plan_watch.h"

namespace tst_plan_watch {

using namespace usar;
using namespace usar::widgets;
using News = PlanWatch::News;

namespace {

const std::string plan = "((AP p (note walk)) (DC d (drives ((high (trigger ((danger))) dodge)) ((work p)))))";

/// What a robot's session says at once, with the values themselves.
struct Said {
    std::vector<agent::Published> published{};
    Seconds now{0.0};
    bool is_replay = false;
    bool rewound = false;
    operator PlanWatch::Update() const { return {published, now, is_replay, rewound}; }
};

/// A robot that publishes what its plan does, a cycle every 0.2 s.
class Flight {
public:
    Flight() : encoder_(plan), engine_(host, *posh::compile(posh::readPlan(plan).plan)) {
        host.setResult("note", posh::ActResult::Finished);
        host.setResult("walk", posh::ActResult::Running);
        engine_.watch(&encoder_);
    }
    ~Flight() { engine_.watch(nullptr); }
    Said cycle() {
        engine_.cycle(posh::Milliseconds(10'000 + 200 * cycles_++));
        return said(encoder_.takeBytes());
    }
    static Said said(const std::string& bytes) { return {{agent::PlanTrace{bytes}}}; }

    test::StubHost host;

private:
    posh::TraceEncoder encoder_;
    posh::Engine engine_;
    int cycles_ = 0;
};

Said replayed(Said update, Seconds now) {
    update.is_replay = true;
    update.now = now;
    return update;
}

/// What runs, by its name, in the shown state.
bool runs(const PlanWatch& watch, const char* names) {
    const posh::Index place = posh::findPlace(*watch.program(), {}, names);
    return watch.snapshot().activities.at(place).running;
}

} // namespace

class tst_PlanWatch : public QObject {
    Q_OBJECT
private slots:
    void followsTheRun();
    void standsAtAMomentWhileTheRunGoesOn();
    void stepsWithinACycle();
    void aReplayWoundBackIsAtAnEarlierMoment();
    void whatIsExpectedOfAReplayIsKnownAtItsFirstWord();
    void aReplayThatGoesOnOtherwiseIsFollowed();
    void anotherRunIsFollowedAnew();
    void withoutARunThereIsNothing();
};

void tst_PlanWatch::followsTheRun() {
    Flight flight;
    PlanWatch watch;
    QCOMPARE(watch.take(flight.cycle()), News::Plan);
    QCOMPARE(watch.planText(), plan);
    QCOMPARE(watch.take(flight.cycle()), News::Activity);
    QVERIFY(watch.live() && runs(watch, "d ▸ work"));
    QCOMPARE(watch.time().cycle, std::uint64_t(2));
    QCOMPARE(watch.time().begin, Seconds(10.0));
    QCOMPARE(watch.time().shown, Seconds(10.2));
    QCOMPARE(watch.take({}), News::None);
}

void tst_PlanWatch::standsAtAMomentWhileTheRunGoesOn() {
    Flight flight;
    PlanWatch watch;
    for (int i = 0; i < 5; ++i)
        watch.take(flight.cycle());
    flight.host.setSense("danger", true);
    watch.take(flight.cycle());
    QVERIFY(runs(watch, "d ▸ high"));
    QCOMPARE(watch.step(-1), News::Activity);
    QVERIFY(!watch.live() && runs(watch, "d ▸ work"));
    watch.take(flight.cycle());
    QVERIFY(runs(watch, "d ▸ work"));
    QCOMPARE(watch.time().cycle, std::uint64_t(5));
    QCOMPARE(watch.time().end, Seconds(11.2));
    watch.goTo(Seconds(10.3));
    QCOMPARE(watch.time().cycle, std::uint64_t(2));
    watch.goTo(Seconds(0.0));
    QCOMPARE(watch.time().cycle, std::uint64_t(1));
    watch.step(-3);
    QCOMPARE(watch.time().cycle, std::uint64_t(1));
    watch.step(100);
    QVERIFY(watch.live() && runs(watch, "d ▸ high"));
}

void tst_PlanWatch::stepsWithinACycle() {
    Flight flight;
    PlanWatch watch;
    watch.take(flight.cycle()); // note, which takes no time, then walk
    QCOMPARE(watch.goToFirstEpoch(), News::Activity);
    QVERIFY(runs(watch, "d ▸ work ▸ p ▸ note") && !runs(watch, "d ▸ work ▸ p ▸ walk"));
    QCOMPARE(watch.time().epoch, std::size_t(1));
    QCOMPARE(watch.time().epochs, std::size_t(2));
    QCOMPARE(watch.stepEpoch(), News::Activity);
    QVERIFY(runs(watch, "d ▸ work ▸ p ▸ walk"));
    QCOMPARE(watch.stepEpoch(), News::None);
    watch.goLive();
    watch.take(flight.cycle()); // walk alone
    QCOMPARE(watch.goToFirstEpoch(), News::None);
}

void tst_PlanWatch::aReplayWoundBackIsAtAnEarlierMoment() {
    Flight flight;
    PlanWatch watch;
    std::vector<Said> updates;
    for (int i = 0; i < 6; ++i) {
        flight.host.setSense("danger", i == 5);
        updates.push_back(flight.cycle());
        updates.back().is_replay = true;
        watch.take(updates.back());
    }
    QVERIFY(runs(watch, "d ▸ high"));
    Said back = updates[0];
    back.rewound = true;
    QCOMPARE(watch.take(back), News::Activity);
    watch.take(updates[1]);
    QVERIFY(watch.live() && runs(watch, "d ▸ work"));
    QCOMPARE(watch.time().cycle, std::uint64_t(2));
    QCOMPARE(watch.time().end, Seconds(11.0)); // the rest is not forgotten
    for (std::size_t i = 2; i < 6; ++i)
        watch.take(updates[i]);
    QVERIFY(runs(watch, "d ▸ high"));
    Said before;
    before.rewound = true;
    QCOMPARE(watch.take(before), News::Plan);
    QVERIFY(watch.empty()); // the plan has not begun yet
    QCOMPARE(watch.take(updates[0]), News::Plan);
    QCOMPARE(watch.time().cycle, std::uint64_t(1));
}

void tst_PlanWatch::whatIsExpectedOfAReplayIsKnownAtItsFirstWord() {
    Flight before; // the same recording holds a run that was another one
    before.host.setSense("danger", true);
    Flight flight;
    PlanWatch flown;
    std::vector<Said> updates;
    for (int i = 0; i < 6; ++i)
        flown.take(updates.emplace_back(flight.cycle()));
    PlanWatch replay;
    replay.expect(flown);
    QVERIFY(replay.empty()); // nothing has been said yet
    for (int i = 0; i < 2; ++i)
        replay.take(replayed(before.cycle(), Seconds(10.0 + 0.2 * i)));
    QVERIFY(runs(replay, "d ▸ high"));
    QCOMPARE(replay.time().end, Seconds(10.2));
    for (std::size_t i = 0; i < 2; ++i)
        replay.take(replayed(updates[i], Seconds(10.0 + 0.2 * static_cast<double>(i))));
    QVERIFY(runs(replay, "d ▸ work"));
    QCOMPARE(replay.time().cycle, std::uint64_t(2));
    QCOMPARE(replay.time().end, Seconds(11.0));
}

void tst_PlanWatch::aReplayThatGoesOnOtherwiseIsFollowed() {
    Flight one;
    Flight other;
    PlanWatch flown;
    PlanWatch replay;
    for (int i = 0; i < 3; ++i)
        flown.take(one.cycle());
    replay.expect(flown);
    replay.take(replayed(other.cycle(), Seconds(10.0)));
    other.host.setSense("danger", true);
    replay.take(replayed(other.cycle(), Seconds(10.2)));
    QVERIFY(runs(replay, "d ▸ high"));
    QCOMPARE(replay.time().cycle, std::uint64_t(2));
    QCOMPARE(replay.time().end, Seconds(10.2));
}

void tst_PlanWatch::anotherRunIsFollowedAnew() {
    Flight first;
    PlanWatch watch;
    for (int i = 0; i < 4; ++i)
        watch.take(first.cycle());
    watch.goTo(Seconds(10.0));
    Flight second;
    QCOMPARE(watch.take(second.cycle()), News::Plan);
    QVERIFY(watch.live());
    QCOMPARE(watch.time().cycle, std::uint64_t(1));
}

void tst_PlanWatch::withoutARunThereIsNothing() {
    PlanWatch watch;
    QVERIFY(watch.empty());
    QCOMPARE(watch.goTo(Seconds(1.0)), News::None);
    QCOMPARE(watch.step(1), News::None);
    QCOMPARE(watch.stepEpoch(), News::None);
    QCOMPARE(watch.goToFirstEpoch(), News::None);
    QCOMPARE(watch.take(Flight::said("no trace at all")), News::None);
    QCOMPARE(watch.time().cycle, std::uint64_t(0));
    QVERIFY(watch.empty() && watch.paths().empty());
}

USAR_TEST(tst_PlanWatch)

} // namespace tst_plan_watch

#include "tst_plan_watch.moc"
