// Traces of short runs of a plan, as a behavior publishes them.
#pragma once

#include <string>
#include <vector>

#include "core/posh/language/plan_reader.h"
#include "core/posh/run/engine.h"
#include "core/posh/trace/trace_encoder.h"
#include "tests/doubles/stub_host.h"

namespace usar::test {

/// Runs the plan for so many cycles, five a second, and returns what each adds to the trace. The sense `near` holds in
/// the first `near` of them.
inline std::vector<std::string> piecesOf(const std::string& plan, int cycles, int near = 0) {
    StubHost host;
    posh::TraceEncoder encoder(plan);
    posh::Engine engine(host, *posh::compile(posh::readPlan(plan).plan));
    engine.watch(&encoder);
    std::vector<std::string> pieces;
    for (int cycle = 1; cycle <= cycles; ++cycle) {
        host.setSense("near", cycle <= near);
        engine.cycle(posh::Milliseconds(200 * cycle));
        pieces.push_back(encoder.takeBytes());
    }
    engine.watch(nullptr);
    return pieces;
}

} // namespace usar::test
