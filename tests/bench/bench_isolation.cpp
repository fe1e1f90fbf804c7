// From STA to DRIVE: what a thread or a process of its own adds to a behavior's answer.
#include <QString>
#include <benchmark/benchmark.h>

#include "core/agent/behavior_host.h"
#include "core/agent/behavior_start.h"
#include "core/protocol/reader.h"

namespace {

using namespace usar;

const QString plugin = QStringLiteral(USAR_BINARY_DIR "/tests/plugins/faulty.so");
const std::string behavior_id = "faulty/none";

agent::PluginLoader& isolationPlugins() {
    static agent::PluginLoader loader;
    if (loader.records().empty())
        loader.scan({plugin});
    return loader;
}

agent::BehaviorContext climbing() {
    return {{}, *agent::ParameterSet::make(isolationPlugins().behavior(behavior_id)->parameters), {}};
}

void answerStates(benchmark::State& state, agent::RunningBehavior& behavior) {
    protocol::Reader reader;
    const protocol::InfoLine line =
        reader.read("STA {Type AerialVehicle} {Time 12.25} {FrontSteer 0.0000} {RearSteer 0.0000} "
                    "{LightToggle False} {LightIntensity 0} {Battery 1199}");
    behavior.begin();
    std::size_t drives = 0;
    for (auto _ : state)
        drives += behavior.receive(line).commands.size();
    if (drives != static_cast<std::size_t>(state.iterations()))
        state.SkipWithError("not every state was answered by a drive");
}

void staToDriveInTheSameThread(benchmark::State& state) {
    auto made = agent::makeBehavior(**isolationPlugins().pluginFor(behavior_id), behavior_id, climbing());
    agent::BehaviorHost host(*std::move(made), behavior_id);
    answerStates(state, host);
}
BENCHMARK(staToDriveInTheSameThread)->UseRealTime();

void staToDriveInAThreadOfItsOwn(benchmark::State& state) {
    answerStates(state, **agent::startBehavior(isolationPlugins(), behavior_id, climbing()));
}
BENCHMARK(staToDriveInAThreadOfItsOwn)->UseRealTime();

void staToDriveInAProcessOfItsOwn(benchmark::State& state) {
    const QString host_program = QStringLiteral(USAR_BINARY_DIR "/bin/usar-behavior-host");
    answerStates(state, **agent::startBehavior(isolationPlugins(), behavior_id, climbing(), host_program));
}
BENCHMARK(staToDriveInAProcessOfItsOwn)->UseRealTime();

} // namespace
