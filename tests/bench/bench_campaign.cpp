// What it costs to go on with a large campaign: its results are read as heads, beside whole lines.
#include <benchmark/benchmark.h>

#include <QJsonArray>
#include <QTemporaryDir>

#include "core/campaign/runs/shard_file.h"

namespace {

using namespace usar::campaign;

constexpr int runs = 10'000;

/// A result with a course, as a campaign keeps it: about four kilobytes.
RunResult resultOf(int number) {
    QJsonArray path;
    for (int i = 0; i < 200; ++i)
        path << QJsonArray{i * 0.25, number * 0.01};
    RunResult result;
    result.number = number;
    result.pair = number;
    result.mission = "quick_scan";
    result.variant = "C++";
    result.reason = "The whole area was scanned.";
    result.version = "1.0";
    result.command = "usar-mission run quick_scan.json --seed 1";
    result.summary = {{"success", true}, {"duration_s", 530.2}, {"course", QJsonObject{{"path", path}}}};
    return result;
}

void read(benchmark::State& state, ResultPart part) {
    const QTemporaryDir folder;
    {
        auto file = ShardFile::open(folder.path(), {});
        for (int i = 0; file && i < runs; ++i)
            if (!file->append(resultOf(i)))
                return state.SkipWithError("cannot write the results");
    }
    for (auto _ : state)
        if (const auto results = readResults(folder.path(), "1.0", part); !results || results->size() != runs)
            return state.SkipWithError("cannot read the results");
    state.SetItemsProcessed(state.iterations() * runs);
}

BENCHMARK_CAPTURE(read, heads, ResultPart::Head)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(read, whole, ResultPart::Whole)->Unit(benchmark::kMillisecond);

} // namespace
