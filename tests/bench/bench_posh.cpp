// What a cycle of a POSH plan costs: n drives asked in turn of which only the last is ready, untraced and traced; what
// loading costs; and beside it a tree of virtual nodes that asks every condition anew, the usual design.
#include <benchmark/benchmark.h>

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/posh/language/plan_reader.h"
#include "core/posh/run/engine.h"
#include "core/posh/trace/trace_encoder.h"
#include "core/posh/trace/trace_file.h"
#include "tests/doubles/allocation_counter.h"

namespace {

using namespace usar::posh;

/// What senses look at: a laser scan, and which drive is ready.
struct World {
    std::vector<double> beams_m = std::vector<double>(181, 4.0);
    std::vector<char> ready;
    double nearest() const {
        double least = beams_m.front();
        for (const double beam_m : beams_m)
            least = beam_m < least ? beam_m : least;
        return least;
    }
};

class BenchHost final : public Host {
public:
    explicit BenchHost(World& world) : world_(world) {}
    bool hasSense(std::string_view) const override { return true; }
    bool hasAct(std::string_view) const override { return true; }
    void bind(const Program& program) override {
        nearest_.clear();
        for (const ProgramCall& call : program.sense_calls)
            nearest_.push_back(call.name == "nearest");
        world_.ready.assign(program.sense_calls.size(), 0);
        world_.ready.back() = 1;
    }
    void sense(CallSite site, Value& answer) override {
        if (nearest_[site.call])
            answer = world_.nearest();
        else
            answer = world_.ready[site.call] != 0;
    }
    void init(CallSite) override {}
    ActResult run(CallSite) override { return ActResult::Running; }
    void done(CallSite, DoneReason) override {}

private:
    World& world_;
    std::vector<char> nearest_;
};

/// Drive i runs when its own sense holds, and nothing is nearer than half a metre where `with_scan`.
std::string drivesText(std::int64_t count, bool with_scan) {
    std::string text = "((DC d (drives ";
    for (std::int64_t i = 0; i < count; ++i) {
        const std::string n = std::to_string(i);
        text += "((d" + n + " (trigger (" + (with_scan ? "(nearest 0.5 >) " : "") + "(s" + n + "))) a" + n + "))";
    }
    return text + ")))";
}

std::shared_ptr<const Program> drivesProgram(std::int64_t count, bool with_scan) {
    return *compile(readPlan(drivesText(count, with_scan)).plan);
}

/// The usual design: nodes on the heap, a virtual call each, conditions as functions, nothing remembered.
class Node {
public:
    virtual ~Node() = default;
    virtual ActResult tick() = 0;
};

class Condition final : public Node {
public:
    Condition(std::function<Value()> sense, Value least) : sense_(std::move(sense)), least_(std::move(least)) {}
    ActResult tick() override {
        const Value answer = sense_();
        const bool holds = std::holds_alternative<bool>(answer) ? std::get<bool>(answer)
                                                                : std::get<double>(answer) > std::get<double>(least_);
        return holds ? ActResult::Finished : ActResult::Failed;
    }

private:
    std::function<Value()> sense_;
    Value least_;
};

class LongAct final : public Node {
public:
    ActResult tick() override { return ActResult::Running; }
};

class Branch final : public Node {
public:
    explicit Branch(ActResult goes_on) : goes_on_(goes_on) {}
    void add(std::unique_ptr<Node> child) { children_.push_back(std::move(child)); }
    ActResult tick() override {
        for (const auto& child : children_)
            if (const ActResult result = child->tick(); result != goes_on_)
                return result;
        return goes_on_;
    }

private:
    ActResult goes_on_; ///< Finished: a sequence, Failed: a fallback
    std::vector<std::unique_ptr<Node>> children_;
};

std::unique_ptr<Node> drivesTree(World& world, std::int64_t count, bool with_scan) {
    auto root = std::make_unique<Branch>(ActResult::Failed);
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
        auto drive = std::make_unique<Branch>(ActResult::Finished);
        if (with_scan)
            drive->add(std::make_unique<Condition>([&world] { return Value(world.nearest()); }, Value(0.5)));
        drive->add(std::make_unique<Condition>([&world, i] { return Value(world.ready[i] != 0); }, Value(true)));
        drive->add(std::make_unique<LongAct>());
        root->add(std::move(drive));
    }
    world.ready.assign(static_cast<std::size_t>(count), 0);
    world.ready.back() = 1;
    return root;
}

/// With an encoder the cycles are also traced, as those of a robot are.
void run(benchmark::State& state, bool with_scan, TraceEncoder* encoder = nullptr) {
    World world;
    BenchHost host(world);
    Engine engine(host, drivesProgram(state.range(0), with_scan));
    engine.watch(encoder);
    std::int64_t time_ms = 0;
    engine.cycle(Milliseconds(time_ms));
    const std::size_t before = allocations;
    std::size_t allocated = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(engine.cycle(Milliseconds(time_ms += 200)));
        if (encoder)
            benchmark::DoNotOptimize(encoder->takeBytes());
        allocated = allocations - before;
    }
    state.counters["allocations"] = static_cast<double>(allocated);
}

void poshCycle(benchmark::State& state) {
    run(state, false);
}
BENCHMARK(poshCycle)->Arg(6)->Arg(20)->Arg(100)->Arg(1000);

void poshCycleTraced(benchmark::State& state) {
    TraceEncoder encoder(drivesText(state.range(0), false));
    run(state, false, &encoder);
}
BENCHMARK(poshCycleTraced)->Arg(6)->Arg(20)->Arg(100)->Arg(1000);

/// Every drive asks the scan as well: once per cycle here, once per drive in the tree.
void poshCycleWithScan(benchmark::State& state) {
    run(state, true);
}
BENCHMARK(poshCycleWithScan)->Arg(20);

void treeTick(benchmark::State& state) {
    World world;
    const auto tree = drivesTree(world, state.range(0), false);
    for (auto _ : state)
        benchmark::DoNotOptimize(tree->tick());
}
BENCHMARK(treeTick)->Arg(6)->Arg(20)->Arg(100)->Arg(1000);

void treeTickWithScan(benchmark::State& state) {
    World world;
    const auto tree = drivesTree(world, state.range(0), true);
    for (auto _ : state)
        benchmark::DoNotOptimize(tree->tick());
}
BENCHMARK(treeTickWithScan)->Arg(20);

/// In turns, so that whatever else the machine does meets both; the counter says how often the tree's time is ours.
void treePerPosh(benchmark::State& state) {
    const bool with_scan = state.range(1) != 0;
    World posh_world;
    World tree_world;
    BenchHost host(posh_world);
    Engine engine(host, drivesProgram(state.range(0), with_scan));
    const auto tree = drivesTree(tree_world, state.range(0), with_scan);
    using Clock = std::chrono::steady_clock;
    Clock::duration posh_time{0};
    Clock::duration tree_time{0};
    std::int64_t time_ms = 0;
    for (auto _ : state) {
        const auto begin = Clock::now();
        for (int i = 0; i < 100; ++i)
            benchmark::DoNotOptimize(engine.cycle(Milliseconds(time_ms += 200)));
        const auto middle = Clock::now();
        for (int i = 0; i < 100; ++i)
            benchmark::DoNotOptimize(tree->tick());
        posh_time += middle - begin;
        tree_time += Clock::now() - middle;
    }
    state.counters["tree/posh"] = std::chrono::duration<double>(tree_time) / std::chrono::duration<double>(posh_time);
}
BENCHMARK(treePerPosh)->ArgNames({"drives", "scan"})->Args({20, 0})->Args({20, 1})->Args({1000, 0});

/// Competences of eight elements, each of two senses.
std::string largePlan(std::int64_t elements) {
    std::string text = "((DC d (drives";
    for (std::int64_t c = 0; c < elements / 8; ++c)
        text +=
            " ((d" + std::to_string(c) + " (trigger ((s" + std::to_string(c % 50) + "))) c" + std::to_string(c) + "))";
    text += "))\n";
    for (std::int64_t c = 0; c < elements / 8; ++c) {
        text += "(C c" + std::to_string(c) + " (elements";
        for (int e = 0; e < 8; ++e)
            text += "\n  ((e" + std::to_string(e) + " (trigger ((s" + std::to_string(e) + ") (distance 0.5 <))) a" +
                    std::to_string(e) + "(1.5) 3))";
        text += "))\n";
    }
    return text + ")";
}

void loadPlan(benchmark::State& state) {
    const std::string text = largePlan(state.range(0));
    for (auto _ : state)
        benchmark::DoNotOptimize(compile(readPlan(text).plan));
}
BENCHMARK(loadPlan)->Arg(3000)->Unit(benchmark::kMillisecond);

void compilePlan(benchmark::State& state) {
    const PlanReading reading = readPlan(largePlan(state.range(0)));
    for (auto _ : state)
        benchmark::DoNotOptimize(compile(reading.plan));
}
BENCHMARK(compilePlan)->Arg(3000)->Unit(benchmark::kMillisecond);

/// A run of twenty drives at 5 Hz in which a measurement changes in each cycle, and every ten seconds another drive
/// wins.
std::string recordedRun(std::int64_t hours) {
    World world;
    BenchHost host(world);
    TraceEncoder encoder(drivesText(20, true));
    Engine engine(host, drivesProgram(20, true));
    engine.watch(&encoder);
    std::string bytes;
    for (std::int64_t cycle = 0; cycle < hours * 18'000; ++cycle) {
        world.beams_m[0] = 1.0 + static_cast<double>(cycle % 977) * 0.001;
        world.ready[1] = cycle / 50 % 2 ? 1 : 0;
        engine.cycle(Milliseconds(200 * cycle));
        bytes += encoder.takeBytes();
    }
    engine.watch(nullptr);
    return bytes;
}

void replayHour(benchmark::State& state) {
    const std::string bytes = recordedRun(1);
    for (auto _ : state) {
        const auto file = TraceFile::open(bytes);
        std::size_t events = 0;
        auto cursor = file->begin();
        while (const TracedCycle* const cycle = cursor.next())
            events += cycle->events.size();
        benchmark::DoNotOptimize(events);
        state.counters["events"] = static_cast<double>(events);
    }
    state.counters["bytes/cycle"] = static_cast<double>(bytes.size()) / 18'000;
}
BENCHMARK(replayHour)->Unit(benchmark::kMillisecond);

/// From nothing but the bytes of a day: the index and the cycle.
void openAndSeekInDay(benchmark::State& state) {
    const std::string bytes = recordedRun(24);
    std::uint64_t cycle = 1;
    for (auto _ : state) {
        const auto file = TraceFile::open(bytes);
        cycle = (cycle * 7919 + 255) % (24 * 18'000) + 1;
        auto cursor = file->seek(cycle);
        benchmark::DoNotOptimize(cursor.next());
    }
}
BENCHMARK(openAndSeekInDay)->Unit(benchmark::kMillisecond);

} // namespace
