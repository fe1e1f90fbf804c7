#include <QAction>
#include <QHBoxLayout>
#include <QVBoxLayout>

#include "tests/widgets/gallery/pages.h"
#include "widgets/map/map_view.h"
#include "widgets/panels/behavior_panel.h"
#include "widgets/panels/parameter_form.h"
#include "widgets/panels/sensor_panel.h"
#include "widgets/panels/status_strip.h"
#include "widgets/style/theme.h"

namespace usar::gallery {

using namespace usar::widgets;

namespace {

BehaviorPanel* behavior(RunState state, const QString& robot) {
    auto* form = new ParameterForm;
    form->setSpecs({{"altitude_m", "Scan altitude", "Flight", "m", 6.0, 2.0, 40.0, "Height over the ground.", {}},
                    {"recharge", "Recharge and resume", "Battery", "", true, 0.0, 0.0, "Land to recharge.", {}}});
    auto* panel = new BehaviorPanel(form);
    panel->setBehaviors({{"airrobot/cpp", "Terrain survey (C++)", "Scans the area in lanes.", true, {}}});
    panel->setAreaLimits({Vec2(-64, -64), Vec2(64, 64)});
    const auto action = [panel](bool enabled) {
        auto* made = new QAction(panel);
        made->setEnabled(enabled);
        return made;
    };
    const bool busy = state == RunState::Running || state == RunState::Paused;
    panel->setActions(action(state == RunState::Ready), action(busy), action(busy), action(busy));
    panel->setRunState(state, robot);
    return panel;
}

SensorPanel* sensors(bool silent) {
    auto* panel = new SensorPanel;
    for (int i = 1; i < 20; ++i) {
        const Seconds now(0.2 * i);
        panel->take({{1}, {}, protocol::InsReading{{}, "INS", {{31.24, -8.02, 6.31}, 0.01, -0.02, 1.57}}, {}}, now);
        panel->take({{1}, {}, protocol::SonarReadings{now, {{"L1", 3.1}, {"M0", 4.95}}}, {}}, now);
        panel->refresh();
    }
    panel->setLinked(!silent);
    panel->refresh();
    return panel;
}

} // namespace

std::unique_ptr<QWidget> behaviorsPage() {
    auto page = std::make_unique<QWidget>();
    page->resize(1180, 520);
    auto* row = new QHBoxLayout(page.get());
    row->addWidget(behavior(RunState::NoRobot, {}));
    auto* ready = behavior(RunState::Ready, QStringLiteral("R1"));
    ready->setArea(Rectangle{Vec2(-30, -20), Vec2(30, 20)});
    ready->setPlanSummary(QStringLiteral("6 lanes · 412 m · about 4 min 40 s\nIn the open: 4 min 10 s to 5 min 20 s, "
                                         "one sortie, 98 to 100 % of the area shown"));
    row->addWidget(ready);
    auto* running = behavior(RunState::Running, QStringLiteral("R1"));
    running->setArea(Rectangle{Vec2(-30, -20), Vec2(90, 20)});
    running->setAreaToolActive(true);
    row->addWidget(running);
    auto* paused = behavior(RunState::Paused, QStringLiteral("Hilltop-watcher"));
    paused->setArea(Rectangle{Vec2(5, 0), Vec2(5, 20)});
    paused->setPlanSummary(QStringLiteral("The area is too small for one lane. Make it wider than 2 m."));
    row->addWidget(paused);
    return page;
}

std::unique_ptr<QWidget> stalePage() {
    auto page = std::make_unique<QWidget>();
    page->resize(720, 420);
    auto* row = new QHBoxLayout(page.get());
    auto* strip = new StatusStrip;
    strip->setStatus({Seconds(751.0), Seconds(751.0), "returning to recharge, 120 m to go over the wood", 38.0, 92.0,
                      412.0, 42.0, Seconds(980.0), 1204.0, 1, false, TimeRange{Seconds(900.0), Seconds(1080.0)}});
    strip->setBattery(8.0);
    strip->setCoverage(61.0);
    strip->setStale(true);
    strip->setFixedWidth(312);
    row->addWidget(strip, 0, Qt::AlignTop);
    row->addWidget(sensors(true));
    return page;
}

std::unique_ptr<QWidget> emptySensorsPage() {
    auto panel = std::make_unique<SensorPanel>();
    panel->resize(312, 240);
    return panel;
}

std::unique_ptr<QWidget> spawnedPage() {
    auto view = std::make_unique<MapView>();
    view->resize(640, 420);
    view->setWorld({{-64.0, -64.0}, {64.0, 64.0}}, QStringLiteral("tall_test"));
    view->setOrientation(MapOrientation::YUp);
    view->setStartPoses({{"PlayerStart", {{0.0, 0.0, 0.0}, 0.0, 0.0, 0.4}},
                         {"HillTop", {{-40.0, 38.0, 0.0}, 0.0, 0.0, -1.6}},
                         {"Valley", {{-36.0, 34.0, 0.0}, 0.0, 0.0, 2.0}},
                         {"EastEnd", {{60.0, -60.0, 0.0}, 0.0, 0.0, 3.1}}});
    view->setRobot({QStringLiteral("R1"), 1, {{0.0, 0.0, 0.0}, 0.0, 0.0, 0.4}});
    view->setRobot({QStringLiteral("R2"), 2, {{-40.0, 36.0, 0.0}, 0.0, 0.0, -1.6}});
    view->setRobot({QStringLiteral("R3"), 3, {{40.0, 3.0, 0.0}, 0.0, 0.0, -1.6}});
    view->setRobot({QStringLiteral("Hilltop-watcher"), 4, {{44.0, 0.0, 0.0}, 0.0, 0.0, -1.6}, true});
    view->selectRobot(QStringLiteral("R1"));
    return view;
}

} // namespace usar::gallery
