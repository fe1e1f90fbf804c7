// The cost of a picture of the plot: two curves of many samples, all of them in view.
#include <string>

#include <benchmark/benchmark.h>

#include <QImage>

#include "core/protocol/reader.h"
#include "tests/bench/bench_application.h"
#include "widgets/models/series_store.h"
#include "widgets/panels/plot_canvas.h"

using namespace usar;

namespace {

void plotFrame(benchmark::State& state) {
    bench::needApplication();
    widgets::SeriesStore store;
    store.add("SEN Sonar/F1/range");
    store.add("SEN Sonar/F2/range");
    protocol::Reader reader;
    for (int i = 0; i < state.range(0); ++i) {
        const std::string range = std::to_string(1 + i % 400 * 0.01);
        store.take(reader.read("SEN {Time " + std::to_string(i * 0.2) + "} {Type Sonar} {Name F1 Range " + range +
                               "} {Name F2 Range " + range + "}"),
                   {});
    }
    widgets::PlotCanvas canvas;
    canvas.resize(800, 400);
    QImage frame(canvas.size(), QImage::Format_ARGB32_Premultiplied);
    for ([[maybe_unused]] auto _ : state) {
        canvas.show(store);
        canvas.render(&frame);
    }
}
BENCHMARK(plotFrame)->Name("plot 800 x 400, two curves, samples")->Arg(2000)->Arg(20000)->Unit(benchmark::kMillisecond);

} // namespace
