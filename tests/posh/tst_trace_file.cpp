// Recorded traces: what was recorded comes out again, from any cycle, while it grows, and when it is damaged.
#include <QTest>

#include <cstdlib>

#include "core/base/random.h"
#include "core/posh/language/plan_reader.h"
#include "core/posh/language/plan_writer.h"
#include "core/posh/trace/trace_encoder.h"
#include "core/posh/trace/trace_file.h"
#include "tests/doubles/trace_text.h"
#include "tests/posh/random_plan.h"
#include "tests/posh/scripted_host.h"
#include "tests/posh/trial.h"
#include "tests/suite/suite.h"

namespace tst_trace_file {

using namespace usar;
using namespace usar::posh;
using test::TraceDetail;

namespace {

/// Hands everything to two observers.
class Both final : public TraceObserver {
public:
    Both(TraceObserver& a, TraceObserver& b) : a_(a), b_(b) {}
    void takeProgram(const std::shared_ptr<const Program>& program) override {
        a_.takeProgram(program);
        b_.takeProgram(program);
    }
    void take(const TraceRecord& record, std::string_view text) override {
        a_.take(record, text);
        b_.take(record, text);
    }

private:
    TraceObserver& a_;
    TraceObserver& b_;
};

/// Its act, which goes on and on, sends a command each time.
class TalkingHost final : public test::StubHost {
public:
    explicit TalkingHost(TraceObserver& trace) : trace_(trace) {}
    ActResult run(CallSite) override {
        trace_.take({.event = TraceEvent::Command}, "DRIVE " + std::to_string(runs_++));
        return ActResult::Running;
    }

private:
    TraceObserver& trace_;
    int runs_ = 0;
};

struct Recording {
    std::string bytes;
    std::string text; ///< in full
};

Recording recorded(const Plan& plan, std::uint64_t seed, std::uint64_t cycles, bool throws = false) {
    ScriptedHost host({.seed = seed, .throws = throws});
    TraceEncoder encoder(writePlan(plan));
    test::TraceText text(TraceDetail::Full);
    Both both(encoder, text);
    {
        Engine engine(host, *compile(plan));
        engine.watch(&both);
        for (std::uint64_t cycle = 1; cycle <= cycles; ++cycle) {
            host.begin(cycle);
            engine.cycle(Milliseconds(200 * cycle + cycle % 7));
        }
    }
    return {encoder.takeBytes(), text.text()};
}

/// Of the cycles from here on, in full.
std::string textFrom(TraceFile::Cursor cursor) {
    std::string text;
    while (const TracedCycle* const cycle = cursor.next())
        for (const auto* events : {&cycle->events, &cycle->behind})
            for (const trace_codec::Entry& entry : *events)
                appendLine(text, *cycle->program, entry.record, cycle->textOf(entry), TraceDetail::Full);
    return text;
}

std::string fromCycle(const std::string& text, std::uint64_t cycle) {
    const std::size_t at = text.find("cycle " + std::to_string(cycle) + " ");
    return at == std::string::npos ? std::string() : text.substr(at);
}

Plan somePlan() {
    Random random = seeded(5, 12);
    return doubles::randomPlan(random);
}

} // namespace

class tst_TraceFile : public QObject {
    Q_OBJECT
private slots:
    void comesOutAsItHappened();
    void beginsAtAnyCycle();
    void knowsThePlanOfEachCycle();
    void isReadWhileItGrows();
    void whatComesBehindACycleLaterHidesNoCycle();
    void quietCyclesCostLittle_data();
    void quietCyclesCostLittle();
    void everyPrefixIsReadAsFarAsItGoes();
    void damagedBytesNeverCrash();
    void aDamagedFrameBehindACycleIsLeftOut();
    void cyclesBeforeADamagedByteStay();
    void rejectsWhatIsNoTrace();
};

void tst_TraceFile::comesOutAsItHappened() {
    Random random = seeded(5, 13);
    for (std::uint64_t seed = 0; seed < 500; ++seed) {
        const Recording run = recorded(doubles::randomPlan(random), seed, 60, seed % 4 == 0);
        const auto file = TraceFile::open(run.bytes);
        QVERIFY(file);
        QCOMPARE(file->cycleCount(), std::size_t(60));
        QVERIFY(file->damage().empty());
        QCOMPARE(textFrom(file->begin()), run.text);
    }
}

void tst_TraceFile::beginsAtAnyCycle() {
    const Recording run = recorded(somePlan(), 3, 1000);
    const auto file = TraceFile::open(run.bytes);
    QVERIFY(file);
    for (const std::uint64_t cycle : {1, 2, 255, 256, 257, 258, 512, 513, 900, 1000})
        QCOMPARE(textFrom(file->seek(cycle)), fromCycle(run.text, cycle));
    QCOMPARE(textFrom(file->seek(0)), run.text);
    QCOMPARE(textFrom(file->seek(1001)), std::string());
}

void tst_TraceFile::knowsThePlanOfEachCycle() {
    const std::string first = "((DC d (drives ((a walk)))))";
    const std::string second = "((DC e (drives ((b swim)))))";
    TrialHost host;
    host.setResult("walk", ActResult::Running);
    TraceEncoder encoder(first);
    Engine engine(host, programOf(first));
    engine.watch(&encoder);
    engine.cycle(Milliseconds(0));
    encoder.setPlanText(second);
    engine.replace(programOf(second));
    engine.cycle(Milliseconds(200));
    const std::string bytes = encoder.takeBytes();
    const auto file = TraceFile::open(bytes);
    QVERIFY(file);
    QCOMPARE(file->planCount(), std::size_t(2));
    QCOMPARE(file->planText(1), second);
    auto cursor = file->begin();
    const TracedCycle* cycle = cursor.next();
    QVERIFY(cycle);
    QCOMPARE(cycle->program->title, std::string("d"));
    QCOMPARE(cycle->behind.size(), std::size_t(1));
    QCOMPARE(cycle->behind.front().record.reason(), DoneReason::Stopped);
    cycle = cursor.next();
    QVERIFY(cycle);
    QCOMPARE(cycle->program->title, std::string("e"));
    engine.watch(nullptr);
}

void tst_TraceFile::isReadWhileItGrows() {
    const Recording run = recorded(somePlan(), 4, 300);
    const std::string_view bytes = run.bytes;
    auto file = TraceFile::open(bytes.substr(0, trace_codec::magic.size()));
    QVERIFY(file);
    std::size_t cycles = 0;
    for (std::size_t size = trace_codec::magic.size(); size <= bytes.size(); size += 7) {
        file->extend(bytes.substr(0, size));
        QVERIFY(file->cycleCount() >= cycles);
        cycles = file->cycleCount();
    }
    file->extend(bytes);
    QCOMPARE(textFrom(file->begin()), run.text);
}

/// As in a live flight: each cycle is read at once, and commands are sent between two cycles.
void tst_TraceFile::whatComesBehindACycleLaterHidesNoCycle() {
    const std::string plan = "((DC d (drives ((a walk)))))";
    TraceEncoder encoder(plan);
    TalkingHost host(encoder);
    Engine engine(host, programOf(plan));
    engine.watch(&encoder);
    std::string bytes;
    std::optional<TraceFile> file;
    std::optional<TraceFile::Cursor> cursor;
    std::vector<std::string> said;
    const auto read = [&] {
        bytes += encoder.takeBytes();
        if (!file)
            file = *TraceFile::open(bytes);
        file->extend(bytes);
        if (!cursor)
            cursor = file->begin();
        while (const TracedCycle* const cycle = cursor->next())
            for (const trace_codec::Entry& entry : cycle->events)
                if (entry.record.event == TraceEvent::Command)
                    said.emplace_back(cycle->textOf(entry));
    };
    for (int cycle = 0; cycle < 5; ++cycle) {
        engine.cycle(Milliseconds(200 * cycle));
        read();
        encoder.take({.event = TraceEvent::Command}, "GETGEO " + std::to_string(cycle));
        read();
    }
    engine.watch(nullptr);
    QCOMPARE(said, (std::vector<std::string>{"DRIVE 0", "DRIVE 1", "DRIVE 2", "DRIVE 3", "DRIVE 4"}));
}

void tst_TraceFile::quietCyclesCostLittle_data() {
    QTest::addColumn<int>("noisy_senses"); // of the twenty; they answer another number in each cycle
    QTest::addColumn<double>("most_bytes");
    QTest::newRow("nothing changes") << 0 << 6.0;
    QTest::newRow("one sense is a measurement") << 1 << 18.0;
    QTest::newRow("three senses are measurements") << 3 << 40.0;
}

void tst_TraceFile::quietCyclesCostLittle() {
    QFETCH(int, noisy_senses);
    QFETCH(double, most_bytes);
    std::string plan = "((DC d (drives";
    for (int i = 0; i < 20; ++i)
        plan += " ((n" + std::to_string(i) + " (trigger ((s" + std::to_string(i) + " 0.5 <))) a))";
    plan += " ((rest sit)))))";
    TrialHost host;
    host.setResult("sit", ActResult::Running);
    for (int i = 0; i < 20; ++i)
        host.setSense("s" + std::to_string(i), 2.0);
    TraceEncoder encoder(plan);
    Engine engine(host, programOf(plan));
    engine.watch(&encoder);
    engine.cycle(Milliseconds(0));
    encoder.takeBytes();
    Random random = seeded(5, 14);
    constexpr int cycles = 1000;
    for (int cycle = 1; cycle <= cycles; ++cycle) {
        for (int i = 0; i < noisy_senses; ++i)
            host.setSense("s" + std::to_string(i), uniform(random, 1.0, 9.0));
        engine.cycle(Milliseconds(200 * cycle));
    }
    const double bytes = static_cast<double>(encoder.takeBytes().size()) / cycles;
    qInfo("%.1f bytes a cycle", bytes);
    QVERIFY(bytes <= most_bytes);
    engine.watch(nullptr);
}

void tst_TraceFile::everyPrefixIsReadAsFarAsItGoes() {
    const Recording run = recorded(somePlan(), 5, 20);
    for (std::size_t size = 0; size <= run.bytes.size(); ++size) {
        const std::string prefix = run.bytes.substr(0, size); // of its own, so that a look behind the end is seen
        const auto file = TraceFile::open(prefix);
        QCOMPARE(file.has_value(), size >= trace_codec::magic.size());
        if (file)
            QVERIFY(run.text.starts_with(textFrom(file->begin())));
    }
}

void tst_TraceFile::damagedBytesNeverCrash() {
    const Recording run = recorded(somePlan(), 6, 40, true);
    Random random = seeded(5, 15);
    for (int round = 0; round < 20'000; ++round) {
        std::string bytes = run.bytes;
        for (int i = 0; i < 3; ++i)
            bytes[trace_codec::magic.size() + random() % (bytes.size() - trace_codec::magic.size())] =
                static_cast<char>(random());
        const auto file = TraceFile::open(bytes);
        QVERIFY(file);
        auto cursor = file->begin();
        std::string text;
        while (const TracedCycle* const cycle = cursor.next())
            for (const trace_codec::Entry& entry : cycle->events)
                if (cycle->program)
                    appendLine(text, *cycle->program, entry.record, cycle->textOf(entry), TraceDetail::Full);
    }
}

void tst_TraceFile::aDamagedFrameBehindACycleIsLeftOut() {
    const Plan plan = readPlan("((DC d (drives ((a walk)))))").plan;
    const Recording sound = recorded(plan, 1, 5);
    const std::size_t places = (*compile(plan))->places.size();
    // Between two cycles, an event at place 66.
    const std::string bytes = sound.bytes + std::string("\x0a"
                                                        "B\x22\x0a\x42\x00\x00\x00\x00\x00\x00",
                                                        11);
    const auto file = TraceFile::open(bytes);
    QVERIFY(file);
    auto cursor = file->begin();
    std::size_t cycles = 0;
    for (const TracedCycle* cycle = cursor.next(); cycle; cycle = cursor.next(), ++cycles)
        for (const trace_codec::Entry& entry : cycle->behind)
            QVERIFY(entry.record.place < places);
    QCOMPARE(cycles, std::size_t(5));
}

void tst_TraceFile::rejectsWhatIsNoTrace() {
    QVERIFY(!TraceFile::open(""));
    QVERIFY(!TraceFile::open("USARPOSH2\nof another version"));
}

/// Puts five other values at each byte. Whatever comes after it, the cycles whose frames end before it are as they
/// were.
void tst_TraceFile::cyclesBeforeADamagedByteStay() {
    const Recording run = recorded(somePlan(), 7, 12);
    const auto eventsOf = [](const std::string& bytes, std::size_t cycles) {
        const auto file = TraceFile::open(bytes);
        std::string text;
        TraceFile::Cursor cursor = file->begin();
        while (cycles-- > 0)
            if (const TracedCycle* const cycle = cursor.next(); cycle && cycle->program)
                for (const trace_codec::Entry& entry : cycle->events)
                    appendLine(text, *cycle->program, entry.record, cycle->textOf(entry), TraceDetail::Full);
        return text;
    };
    std::size_t most = 0;
    for (std::size_t at = trace_codec::magic.size(); at < run.bytes.size(); ++at) {
        const std::string before = run.bytes.substr(0, at);
        const std::size_t whole = TraceFile::open(before)->cycleCount();
        const std::string expected = eventsOf(run.bytes, whole);
        most = std::max(most, whole);
        for (const int change : {0x01, 0x08, 0x40, 0x80, 0xFF}) {
            std::string damaged = run.bytes;
            damaged[at] = static_cast<char>(damaged[at] ^ change);
            if (eventsOf(damaged, whole) != expected)
                QFAIL(qPrintable(QString("byte %1 changed by %2").arg(at).arg(change)));
        }
    }
    QVERIFY(most >= 11);
}

USAR_TEST(tst_TraceFile)

} // namespace tst_trace_file

#include "tst_trace_file.moc"
