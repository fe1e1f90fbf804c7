// What must hold of every run, tried on ten thousand plans made by chance.
#include <QTest>

#include <deque>

#include "core/base/random.h"
#include "core/posh/language/plan_reader.h"
#include "core/posh/language/plan_writer.h"
#include "core/posh/run/engine.h"
#include "tests/posh/plan_corpus.h"
#include "tests/posh/random_plan.h"
#include "tests/posh/run_monitor.h"
#include "tests/posh/scripted_host.h"
#include "tests/suite/suite.h"

namespace tst_engine_properties {

using namespace usar;
using namespace usar::posh;

namespace {

constexpr int plans = 10'000;
constexpr int cycles = 25;

/// What an act did, whatever its path: "3 init fly(2)".
struct Deed {
    std::uint64_t cycle = 0;
    TraceEvent event = TraceEvent::ActInit;
    std::uint8_t detail = 0;
    std::string call;
    bool operator==(const Deed&) const = default;
};

/// Keeps a run.
class Log final : public TraceObserver {
public:
    struct Entry {
        TraceRecord record;
        std::string text;
        bool operator==(const Entry&) const = default;
    };
    std::vector<Entry> entries;
    std::shared_ptr<const Program> program;

    void takeProgram(const std::shared_ptr<const Program>& shared) override { program = shared; }
    void take(const TraceRecord& record, std::string_view text) override {
        entries.push_back({record, std::string(text)});
    }
    std::vector<Deed> deeds() const {
        std::vector<Deed> made;
        for (const auto& [record, text] : entries)
            if (record.event == TraceEvent::ActInit || record.event == TraceEvent::ActRun ||
                record.event == TraceEvent::ActDone)
                made.push_back({record.cycle, record.event, record.detail, callTextAt(*program, record.place)});
        return made;
    }
};

/// Times that stand still, jump and try to go back, by the cycle.
Milliseconds timeOf(std::uint64_t cycle) {
    return Milliseconds(static_cast<std::int64_t>(cycle * 200 + cycle % 5 * 37) - (cycle % 7 == 6 ? 300 : 0));
}

EngineOptions optionsFor(std::uint64_t seed) {
    EngineOptions options;
    options.most_acts = 1 + static_cast<int>(seed % 5);
    options.on_goal = seed % 3 == 0 ? OnGoal::Stop : OnGoal::Hold;
    return options;
}

std::shared_ptr<const Program> compiled(const Plan& plan) {
    const auto program = compile(plan);
    if (!program)
        throw std::runtime_error(program.error().text());
    return *program;
}

template <class AnyHost>
void run(AnyHost& host, const std::shared_ptr<const Program>& program, std::uint64_t seed, TraceObserver& observer) {
    Engine engine(host, program, optionsFor(seed));
    engine.watch(&observer);
    for (std::uint64_t cycle = 1; cycle <= cycles; ++cycle) {
        if constexpr (requires { host.begin(cycle); })
            host.begin(cycle);
        engine.cycle(timeOf(cycle));
    }
    engine.watch(nullptr);
}

Log logOf(const Plan& plan, std::uint64_t seed, bool runs_long = true) {
    ScriptedHost host({.seed = seed, .runs_long = runs_long});
    Log log;
    run(host, compiled(plan), seed, log);
    return log;
}

/// Answers what a log says was answered.
class ReplayHost final : public Host {
public:
    explicit ReplayHost(const Log& log) {
        for (const auto& [record, text] : log.entries)
            if (record.event == TraceEvent::SenseEval && !(record.flags & trace_cached))
                answers_.push_back(answerOf(record, text));
            else if (record.event == TraceEvent::ActRun)
                results_.push_back(record.result());
    }
    bool hasSense(std::string_view) const override { return true; }
    bool hasAct(std::string_view) const override { return true; }
    void bind(const Program&) override {}
    void sense(CallSite, Value& answer) override { answer = next(answers_); }
    void init(CallSite) override {}
    ActResult run(CallSite) override { return next(results_); }
    void done(CallSite, DoneReason) override {}

private:
    template <class T>
    static T next(std::deque<T>& queue) {
        if (queue.empty())
            throw std::runtime_error("the replay asks more than the run did");
        T value = std::move(queue.front());
        queue.pop_front();
        return value;
    }
    std::deque<Value> answers_;
    std::deque<ActResult> results_;
};

void renameMembers(Plan& plan) {
    for (Form& form : plan.forms)
        if (Levels* const levels = levelsIn(form))
            for (Level& level : *levels)
                for (Member& member : level)
                    member.name.text += "-renamed";
}

void addUnusedForm(Plan& plan) {
    plan.forms.insert(plan.forms.begin(), Competence{{"unused", {}}, {}, {}, {}, {}, {}, {}, {}});
}

void insertIdleDrives(Plan& plan) {
    for (Form& form : plan.forms)
        if (auto* const collection = std::get_if<Collection>(&form)) {
            Member idle;
            idle.name.text = "idle";
            idle.trigger.push_back({{{"never", {}}, {}}, {}, {}});
            idle.action.name.text = "a0";
            collection->levels.insert(collection->levels.begin(), Level{idle, idle});
        }
}

/// Puts every act with constant arguments into a pattern of its own.
class Wrapper {
public:
    explicit Wrapper(Plan& plan) : plan_(plan) {
        for (const Form& form : plan.forms)
            forms_.insert(nameOf(form).text);
    }
    void wrap() {
        for (Form& form : plan_.forms)
            std::visit([this](auto& any) { wrapIn(any); }, form);
        plan_.forms.insert(plan_.forms.end(), patterns_.begin(), patterns_.end());
    }

private:
    void wrapIn(Competence& competence) { wrapIn(competence.levels); }
    void wrapIn(Collection& collection) { wrapIn(collection.levels); }
    void wrapIn(Levels& levels) {
        for (Level& level : levels)
            for (Member& member : level)
                wrapCall(member.action);
    }
    void wrapIn(Pattern& pattern) {
        for (Step& step : pattern.steps)
            if (auto* const call = std::get_if<Call>(&step))
                wrapCall(*call);
    }
    void wrapIn(Adopt& adopt) { wrapCall(adopt.adopted); }
    void wrapCall(Call& call) {
        if (forms_.contains(call.name.text))
            return;
        for (const Argument& argument : call.arguments)
            if (std::holds_alternative<Variable>(argument.value))
                return;
        const std::string name = "wrapped" + std::to_string(patterns_.size());
        patterns_.emplace_back(Pattern{{name, {}}, {}, {}, {call}, {}, {}, {}});
        call = {{name, {}}, {}};
    }

    Plan& plan_;
    std::set<std::string> forms_;
    std::vector<Form> patterns_;
};

} // namespace

class tst_EngineProperties : public QObject {
    Q_OBJECT
private slots:
    void everyRunKeepsTheRules_data();
    void everyRunKeepsTheRules();
    void plansOfPeopleKeepTheRulesToo_data();
    void plansOfPeopleKeepTheRulesToo();
    void aRunIsAFunctionOfItsInputs();
    void namesAndUnusedFormsChangeNothing();
    void drivesThatAreNeverReadyChangeNothing();
    void aRunGoesOnWithAPlanOfTheSameShape();
    void aPatternOfOneActIsTheAct();
    void writtenAndReadAgainAPlanRunsTheSame();
    void aRunReplayedWithItsAnswersIsTheSame();
    void equalDrivesTakeTurns();

private:
    template <class Check>
    static void onEveryPlan(Check&& check) {
        Random random = seeded(5, 11);
        for (std::uint64_t seed = 0; seed < plans; ++seed) {
            const Plan plan = doubles::randomPlan(random);
            check(plan, seed);
            if (QTest::currentTestFailed()) {
                qWarning("seed %llu: %s", static_cast<unsigned long long>(seed), writePlan(plan).c_str());
                return;
            }
        }
    }
};

void tst_EngineProperties::everyRunKeepsTheRules_data() {
    QTest::addColumn<bool>("throws");
    QTest::newRow("a host that behaves") << false;
    QTest::newRow("a host that throws") << true;
}

void tst_EngineProperties::everyRunKeepsTheRules() {
    QFETCH(bool, throws);
    std::size_t runs = 0;
    onEveryPlan([&](const Plan& plan, std::uint64_t seed) {
        ScriptedHost host({.seed = seed, .throws = throws});
        RunMonitor monitor(optionsFor(seed).most_acts);
        run(host, compiled(plan), seed, monitor);
        QVERIFY2(monitor.complaint().empty(), monitor.complaint().c_str());
        ++runs;
    });
    QCOMPARE(runs, std::size_t(plans));
}

void tst_EngineProperties::plansOfPeopleKeepTheRulesToo_data() {
    QTest::addColumn<QByteArray>("text");
    for (const corpus::PlanFile& file : corpus::soundPlans())
        QTest::addRow("%s", file.name.c_str()) << QByteArray::fromStdString(file.text);
}

void tst_EngineProperties::plansOfPeopleKeepTheRulesToo() {
    QFETCH(QByteArray, text);
    const Plan plan = readPlan(text.toStdString()).plan;
    if (!collectionOf(plan)) {
        QVERIFY(!compile(plan)); // a fragment is refused, and that is all there is to run
        return;
    }
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        ScriptedHost host({.seed = seed, .throws = seed % 2 == 0});
        RunMonitor monitor(optionsFor(seed).most_acts);
        run(host, compiled(plan), seed, monitor);
        QVERIFY2(monitor.complaint().empty(), monitor.complaint().c_str());
    }
}

void tst_EngineProperties::aRunIsAFunctionOfItsInputs() {
    onEveryPlan(
        [](const Plan& plan, std::uint64_t seed) { QVERIFY(logOf(plan, seed).entries == logOf(plan, seed).entries); });
}

void tst_EngineProperties::namesAndUnusedFormsChangeNothing() {
    onEveryPlan([](const Plan& plan, std::uint64_t seed) {
        Plan changed = plan;
        renameMembers(changed);
        addUnusedForm(changed);
        QVERIFY(logOf(plan, seed).deeds() == logOf(changed, seed).deeds());
    });
}

void tst_EngineProperties::drivesThatAreNeverReadyChangeNothing() {
    onEveryPlan([](const Plan& plan, std::uint64_t seed) {
        Plan changed = plan;
        insertIdleDrives(changed);
        QVERIFY(logOf(plan, seed).deeds() == logOf(changed, seed).deeds());
    });
}

void tst_EngineProperties::aRunGoesOnWithAPlanOfTheSameShape() {
    onEveryPlan([](const Plan& plan, std::uint64_t seed) {
        Plan renamed = plan;
        renameMembers(renamed);
        ScriptedHost host({.seed = seed});
        Log log;
        {
            Engine engine(host, compiled(plan), optionsFor(seed));
            engine.watch(&log);
            for (std::uint64_t cycle = 1; cycle <= cycles; ++cycle) {
                if (cycle % 5 == 0) // again and again, and the one before is gone
                    engine.retune(compiled(cycle % 2 ? plan : renamed));
                host.begin(cycle);
                engine.cycle(timeOf(cycle));
            }
            engine.watch(nullptr);
        }
        QVERIFY(log.entries == logOf(plan, seed).entries);
    });
}

void tst_EngineProperties::aPatternOfOneActIsTheAct() {
    onEveryPlan([](const Plan& plan, std::uint64_t seed) {
        Plan changed = plan;
        Wrapper(changed).wrap();
        QVERIFY(logOf(plan, seed, false).deeds() == logOf(changed, seed, false).deeds());
    });
}

void tst_EngineProperties::writtenAndReadAgainAPlanRunsTheSame() {
    onEveryPlan([](const Plan& plan, std::uint64_t seed) {
        const PlanReading reading = readPlan(writePlan(plan));
        QVERIFY(!hasErrors(reading.findings));
        QVERIFY(logOf(plan, seed).entries == logOf(reading.plan, seed).entries);
    });
}

void tst_EngineProperties::aRunReplayedWithItsAnswersIsTheSame() {
    onEveryPlan([](const Plan& plan, std::uint64_t seed) {
        const Log first = logOf(plan, seed);
        ReplayHost host(first);
        Log second;
        run(host, first.program, seed, second);
        QVERIFY(first.entries == second.entries);
    });
}

void tst_EngineProperties::equalDrivesTakeTurns() {
    for (std::size_t count = 1; count < 8; ++count) {
        std::string text = "((DC d (drives (";
        for (std::size_t i = 0; i < count; ++i)
            text += "(n" + std::to_string(i) + " a" + std::to_string(i) + ")";
        ScriptedHost host({.seed = count, .runs_long = false});
        Log log;
        run(host, compiled(readPlan(text + "))))").plan), count, log);
        std::size_t turn = 0;
        for (const auto& [record, unused] : log.entries)
            if (record.event == TraceEvent::DriveStarted)
                QCOMPARE(log.program->places[record.place].item, Index(turn++ % count));
        QVERIFY(turn >= cycles);
    }
}

USAR_TEST(tst_EngineProperties)

} // namespace tst_engine_properties

#include "tst_engine_properties.moc"
