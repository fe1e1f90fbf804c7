// What a frame of the map costs at 1920 x 1080: 200 m x 200 m at 0.25 m, a long trail, panned and zoomed.
#include <cmath>

#include <benchmark/benchmark.h>

#include <QEventLoop>
#include <QImage>
#include <QPainter>

#include "tests/bench/bench_application.h"
#include "widgets/map/map_view.h"
#include "widgets/map/trace_layer.h"
#include "widgets/style/theme.h"

using namespace usar;

namespace {

void fill(widgets::MapView& view) {
    mapping::HeightMap map(0.25);
    for (int column = 0; column < 800; ++column)
        for (int row = 0; row < 800; ++row)
            map.write({column, row}, static_cast<float>((column * 7 + row * 13) % 64), {1});
    view.heights().take(map.takeChangedTiles(), map.range());
    while (view.heights().busy()) {
        QEventLoop loop;
        QObject::connect(&view.heights(), &widgets::HeightLayer::changed, &loop, &QEventLoop::quit);
        loop.exec();
    }
    view.setArea(Rectangle{Vec2(0, 0), Vec2(200, 200)});
    for (int lane = 0; lane < 20; ++lane)
        for (int i = 0; i <= 500; ++i) {
            const double along_m = lane % 2 ? 200 - i * 0.4 : i * 0.4;
            view.setRobot({"R1", 1, {{along_m, 5 + lane * 10 + std::sin(i * 0.2), 6}, 0, 0, 0}});
        }
}

void mapFrame(benchmark::State& state) {
    bench::needApplication();
    widgets::MapView view;
    view.resize(1920, 1080);
    fill(view);
    view.fit();
    widgets::MapTransform transform = view.transform();
    transform.pixels_per_m *= static_cast<double>(state.range(0));
    QImage frame(view.size(), QImage::Format_ARGB32_Premultiplied);
    double side = 1.0;
    for ([[maybe_unused]] auto _ : state) {
        transform.pan({side * 16.0, 0.0});
        side = -side;
        view.setTransform(transform);
        view.render(&frame);
    }
}
BENCHMARK(mapFrame)->Name("map frame 1080p, zoom")->Arg(1)->Arg(4)->Unit(benchmark::kMillisecond);

/// A pan over a hundred thousand marks that robots have left: they are baked into an image.
void tracesFrame(benchmark::State& state) {
    bench::needApplication();
    widgets::TraceLayer layer;
    for (int i = 0; i < 100000; ++i)
        layer.add(50.0 * Vec2(std::sin(i * 0.001), std::cos(i * 0.0013)),
                  widgets::traceColor(protocol::TraceColor::Red));
    widgets::MapTransform transform;
    transform.viewport = {1000, 800};
    transform.pixels_per_m = 8.0;
    QImage image(1000, 800, QImage::Format_ARGB32_Premultiplied);
    QPainter painter(&image);
    layer.paint(painter, transform);
    for ([[maybe_unused]] auto _ : state)
        layer.paint(painter, transform);
}
BENCHMARK(tracesFrame)->Name("100,000 trace marks, painted again")->Unit(benchmark::kMillisecond);

} // namespace
