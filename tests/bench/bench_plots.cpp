// The cost of a picture of the plot: six curves, all of their samples in view. A hundred times as many samples should
// cost about as much, because a line has no more points than the screen has columns.
#include <cmath>
#include <limits>
#include <string>

#include <benchmark/benchmark.h>

#include <QImage>

#include "core/protocol/reader.h"
#include "tests/bench/bench_application.h"
#include "widgets/models/plot/plot_model.h"
#include "widgets/panels/plot_canvas.h"

using namespace usar;

namespace {

constexpr int curves = 6;

/// A line with the ranges of six sonars.
std::string lineAt(int i) {
    std::string line = "SEN {Time " + std::to_string(i * 0.1) + "} {Type Sonar}";
    for (int curve = 1; curve <= curves; ++curve)
        line +=
            " {Name F" + std::to_string(curve) + " Range " + std::to_string(2.0 + std::sin(0.001 * i + curve)) + '}';
    return line;
}

void plotFrame(benchmark::State& state) {
    bench::needApplication();
    widgets::PlotModel model;
    model.setWindow(std::numeric_limits<double>::infinity());
    for (int curve = 1; curve <= curves; ++curve)
        model.add(0, "SEN Sonar/F" + std::to_string(curve) + "/range");
    protocol::Reader reader;
    for (int i = 0; i < state.range(0); ++i)
        model.take("", reader.read(lineAt(i)), {});
    widgets::PlotCanvas canvas(model);
    canvas.resize(800, 400);
    QImage frame(canvas.size(), QImage::Format_ARGB32_Premultiplied);
    for ([[maybe_unused]] auto _ : state) {
        canvas.draw();
        canvas.render(&frame);
    }
}
BENCHMARK(plotFrame)
    ->Name("plot 800 x 400, six curves, samples in each")
    ->Arg(100'000)
    ->Arg(10'000'000)
    ->Unit(benchmark::kMillisecond);

void recordSample(benchmark::State& state) {
    widgets::SampleHistory history;
    double time_s = 0.0;
    for ([[maybe_unused]] auto _ : state) {
        history.append({time_s, std::sin(time_s)});
        time_s += 0.1;
    }
    state.counters["bytes"] = static_cast<double>(history.memory_bytes());
}
BENCHMARK(recordSample)->Name("plot, one sample recorded");

} // namespace
