// Any bytes behind a recorded trace: whatever they are, it is read as far as it is sound, and what is read can be
// shown.
#include <cstdint>
#include <cstdlib>
#include <string>

#include "core/posh/language/plan_reader.h"
#include "core/posh/run/engine.h"
#include "core/posh/trace/trace_encoder.h"
#include "core/posh/trace/trace_file.h"
#include "tests/doubles/stub_host.h"
#include "tests/doubles/trace_text.h"

namespace {

using namespace usar::posh;

constexpr int cycles = 5;

std::string recorded() {
    const std::string plan = "((AP p (one (near 2 <) two)) (DC d (drives ((a (trigger ((name \"x\"))) p)) ((b c)))) "
                             "(C c (elements ((e (trigger ((near))) walk 2)))))";
    usar::test::StubHost host;
    host.setSense("near", 1.5);
    host.setSense("name", std::string("x"));
    TraceEncoder encoder(plan);
    Engine engine(host, *compile(readPlan(plan).plan));
    engine.watch(&encoder);
    for (int cycle = 0; cycle < cycles; ++cycle)
        engine.cycle(Milliseconds(200 * cycle));
    engine.watch(nullptr);
    return encoder.takeBytes();
}

std::size_t show(TraceFile::Cursor cursor) {
    std::size_t read = 0;
    std::string text;
    while (const TracedCycle* const cycle = cursor.next()) {
        ++read;
        for (const auto* const events : {&cycle->events, &cycle->behind})
            for (const trace_codec::Entry& entry : *events)
                if (cycle->program)
                    appendLine(text, *cycle->program, entry.record, cycle->textOf(entry),
                               usar::test::TraceDetail::Full);
        text.clear();
    }
    return read;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const std::string sound = recorded();
    const std::string bytes = sound + std::string(reinterpret_cast<const char*>(data), size);
    const auto file = TraceFile::open(bytes);
    if (!file || show(file->begin()) < cycles)
        std::abort();
    show(file->seek(cycles));
    show(file->seek(size));
    return 0;
}
