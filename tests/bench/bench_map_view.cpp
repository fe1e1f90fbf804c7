// What a frame of the map costs at 1920 x 1080: 200 m x 200 m at 0.25 m, a long trail, panned and zoomed.
#include <algorithm>
#include <cmath>
#include <vector>

#include <benchmark/benchmark.h>

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QImage>
#include <QKeyEvent>
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

/// From an arrow key's event to the whole map painted, with the news of one tick of all robots before it, each with a
/// trail of a hundred meters: the longest that a key waits for. The figure to watch is `p95_ms`.
void keyToPaint(benchmark::State& state) {
    bench::needApplication();
    widgets::MapView view;
    view.resize(1920, 1080);
    fill(view);
    view.fit();
    const auto robots = static_cast<int>(state.range(0));
    const auto tick = [&](int at) {
        for (int robot = 0; robot < robots; ++robot)
            view.setRobot({QStringLiteral("R%1").arg(robot + 1),
                           robot + 1,
                           {{0.2 * at, 4.0 * (robot % 50) + std::sin(at * 0.2), 6}, 0, 0, 0}});
    };
    int at = 0;
    while (at < 500)
        tick(at++);
    QImage frame(view.size(), QImage::Format_ARGB32_Premultiplied);
    view.render(&frame);
    std::vector<double> times_ms;
    for ([[maybe_unused]] auto _ : state) {
        QElapsedTimer clock;
        clock.start();
        tick(++at % 1000);
        const int key = at % 2 ? Qt::Key_Left : Qt::Key_Right;
        QKeyEvent press(QEvent::KeyPress, key, Qt::NoModifier);
        QCoreApplication::sendEvent(&view, &press);
        view.render(&frame);
        times_ms.push_back(static_cast<double>(clock.nsecsElapsed()) * 1e-6);
        QKeyEvent release(QEvent::KeyRelease, key, Qt::NoModifier);
        QCoreApplication::sendEvent(&view, &release);
    }
    std::ranges::sort(times_ms);
    state.counters["p95_ms"] = times_ms[times_ms.size() * 95 / 100];
}
BENCHMARK(keyToPaint)->Name("key to paint, robots")->Arg(1)->Arg(9)->Arg(50)->Unit(benchmark::kMillisecond);

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
