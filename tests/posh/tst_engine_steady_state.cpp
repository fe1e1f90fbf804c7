// A cycle costs no allocation, watched or not: counted at the operator itself.
#include <QTest>

#include "tests/doubles/allocation_counter.h"
#include "tests/posh/trial.h"
#include "tests/suite/suite.h"

namespace tst_engine_steady_state {

using namespace usar::posh;

namespace {

/// Every kind of form, interruptions, retries, limits, frequencies and instant acts.
const char* const busy_plan = R"((
  (C pick vars($far=2.5) (seconds 3) (goal ((held)))
    (elements ((grab (trigger ((distance($far) 5 <))) close 2)) ((turn (trigger ((phase 2 >))) spin)) ((go walk($far)))))
  (C outer (elements ((first pick($far=1.5))) ((second pick))))
  (AP greet (seconds 2) (stop (phase 6 <) outer beep))
  (AD keep ((goal ((held))) (greet)))
  (AP round (keep beep))
  (RDC robot (goal ((over)))
    (drives
      ((safety (trigger ((bumped))) back))
      ((often (trigger ((phase 3 <))) beep (seconds 1)) (equal (trigger ((phase 5 <))) count))
      ((work (trigger ((phase 8 !=))) round))))))";

/// Walks through phases; answers numbers only, as texts are the host's own allocations.
class PhaseHost final : public Host {
public:
    int phase = 0;
    bool hasSense(std::string_view) const override { return true; }
    bool hasAct(std::string_view) const override { return true; }
    void bind(const Program& program) override { program_ = &program; }
    void sense(CallSite site, Value& answer) override {
        const std::string& name = program_->sense_calls[site.call].name;
        if (name == "phase")
            answer = std::int64_t{phase};
        else if (name == "bumped")
            answer = phase == 7;
        else if (name == "held")
            answer = phase == 6;
        else if (name == "distance")
            answer = 0.5 * phase;
    }
    void init(CallSite) override {}
    ActResult run(CallSite site) override {
        const std::string& name = program_->act_calls[site.call].name;
        if (name == "walk" || name == "spin")
            return phase % 4 == 3 ? ActResult::Failed : ActResult::Running;
        return name == "count" ? ActResult::Finished : ActResult::RunningOnce;
    }
    void done(CallSite, DoneReason) override {}

private:
    const Program* program_ = nullptr;
};

class CountingObserver final : public TraceObserver {
public:
    std::size_t records = 0;
    void takeProgram(const std::shared_ptr<const Program>&) override {}
    void take(const TraceRecord&, std::string_view) override { ++records; }
};

} // namespace

class tst_EngineSteadyState : public QObject {
    Q_OBJECT
private slots:
    void aCycleAllocatesNothing_data();
    void aCycleAllocatesNothing();
};

void tst_EngineSteadyState::aCycleAllocatesNothing_data() {
    QTest::addColumn<bool>("watched");
    QTest::newRow("nobody watches") << false;
    QTest::newRow("watched") << true;
}

void tst_EngineSteadyState::aCycleAllocatesNothing() {
    QFETCH(bool, watched);
    PhaseHost host;
    CountingObserver observer;
    Engine engine(host, programOf(busy_plan));
    engine.watch(watched ? &observer : nullptr);
    engine.cycle(Milliseconds(0));
    const std::size_t before = allocations;
    for (int cycle = 1; cycle < 5000; ++cycle) {
        host.phase = (cycle * 7 / 3) % 9;
        engine.cycle(Milliseconds(200 * cycle));
    }
    const std::size_t cost = allocations - before;
    QCOMPARE(cost, std::size_t(0));
    QCOMPARE(observer.records > 20000, watched);
}

USAR_TEST(tst_EngineSteadyState)

} // namespace tst_engine_steady_state

#include "tst_engine_steady_state.moc"
