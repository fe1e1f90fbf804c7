// What a plan of 10,000 elements costs to open, and to pan at 1920 x 1080 with 2,000 of its cards in view.
#include <string>

#include <benchmark/benchmark.h>

#include <QImage>
#include <QKeyEvent>

#include "core/posh/language/plan_reader.h"
#include "tests/bench/bench_application.h"
#include "widgets/plan/plan_view.h"

using namespace usar;

namespace {

/// 100 competences of 100 elements, each with two senses.
posh::Plan largePlan() {
    std::string text = "(";
    std::string drives;
    for (int c = 0; c < 100; ++c) {
        const std::string name = "competence-" + std::to_string(c);
        text += "(C " + name + " (elements ";
        for (int e = 0; e < 100; ++e)
            text += "((element-" + std::to_string(e) + " (trigger ((Distance 0.3 <) (Ready))) Act-" +
                    std::to_string(c * 100 + e) + " 3))\n";
        text += "))";
        drives += "((drive-" + std::to_string(c) + " (trigger ((Battery 0.2 >))) " + name + "))\n";
    }
    return posh::readPlan(text + "(DC large (drives " + drives + ")))").plan;
}

/// 1,000 drives of five competences below each other: 10,000 elements and competences, as broad as it is long.
posh::Plan broadPlan() {
    std::string text = "(";
    std::string drives;
    for (int drive = 0; drive < 1000; ++drive) {
        for (int c = 0; c < 5; ++c) {
            const std::string number = std::to_string(drive) + "-";
            text += "(C look-" + number + std::to_string(c) + " (elements ((go-on-" + number + std::to_string(c) + ' ' +
                    (c < 4 ? "look-" + number + std::to_string(c + 1) : "Act") + "))))\n";
        }
        const std::string number = std::to_string(drive);
        drives += "((drive-" + number + " look-" + number + "-0))\n";
    }
    return posh::readPlan(text + "(DC broad (drives " + drives + ")))").plan;
}

widgets::PlanSnapshot news(const widgets::PlanTree& tree, int cycle) {
    const auto paths = std::make_shared<std::vector<std::string>>();
    for (const widgets::PlanNodeId node : tree.nodes())
        paths->push_back(tree.path(node));
    widgets::PlanSnapshot snapshot{paths, std::vector<widgets::PlanActivity>(paths->size()), Seconds(0.2 * cycle)};
    for (std::size_t i = 0; i < paths->size(); ++i) {
        widgets::PlanActivity& part = snapshot.activities[i];
        part.started = static_cast<std::uint64_t>(cycle);
        part.last_active = Seconds(0.01 * static_cast<double>(i % 100));
        if (tree[{static_cast<int>(i)}].kind == widgets::PlanNodeKind::Sense)
            part.answer = widgets::SenseAnswer{QStringLiteral("0.31"), i % 2 == 0, Seconds(0.0), snapshot.now};
    }
    return snapshot;
}

void openPlan(benchmark::State& state) {
    bench::needApplication();
    const posh::Plan plan = largePlan();
    QImage frame(1920, 1080, QImage::Format_ARGB32_Premultiplied);
    for ([[maybe_unused]] auto _ : state) {
        widgets::PlanView view;
        view.resize(frame.size());
        view.setPlan(plan);
        view.render(&frame);
    }
}
BENCHMARK(openPlan)->Name("open a plan of 10,000 elements")->Unit(benchmark::kMillisecond);

void panPlan(benchmark::State& state) {
    bench::needApplication();
    widgets::PlanView view;
    view.resize(1920, 1080);
    view.setPlan(broadPlan());
    view.setSnapshot(news(view.tree(), 5));
    view.show();
    const auto visible = [&] {
        const QRectF area(view.toLayout({0, 0}), view.toLayout({1920, 1080}));
        return static_cast<std::int64_t>(view.layout().nodesIn(view.tree(), area).size());
    };
    for (int i = 0; i < 40 && visible() < state.range(0); ++i)
        view.zoomOut();
    QImage frame(view.size(), QImage::Format_ARGB32_Premultiplied);
    int side = 1;
    for ([[maybe_unused]] auto _ : state) {
        QKeyEvent key(QEvent::KeyPress, side > 0 ? Qt::Key_Down : Qt::Key_Up, Qt::NoModifier);
        QCoreApplication::sendEvent(&view, &key);
        side = -side;
        view.render(&frame);
    }
    state.counters["visible"] = static_cast<double>(visible());
    state.counters["scale"] = view.scale();
}
BENCHMARK(panPlan)->Name("pan a plan, visible")->Arg(50)->Arg(500)->Arg(2000)->Unit(benchmark::kMillisecond);

void newsOfPlan(benchmark::State& state) {
    bench::needApplication();
    const widgets::PlanTree tree(largePlan());
    const widgets::PlanSnapshot snapshot = news(tree, 5);
    widgets::PlanStates states;
    states.reset(tree);
    for ([[maybe_unused]] auto _ : state)
        states.take(tree, snapshot);
}
BENCHMARK(newsOfPlan)->Name("news of a plan of 10,000 elements")->Unit(benchmark::kMillisecond);

} // namespace
