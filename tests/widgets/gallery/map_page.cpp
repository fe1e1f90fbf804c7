#include <cmath>

#include <QGridLayout>
#include <QLabel>

#include "core/mapping/coverage_path.h"
#include "core/mapping/height_map.h"
#include "tests/widgets/gallery/pages.h"
#include "widgets/map/map_view.h"
#include "widgets/style/icons.h"
#include "widgets/style/theme.h"

namespace usar::gallery {

using namespace usar::widgets;

namespace {

double ground(double x, double y) {
    return 4.0 * std::sin(x / 17.0) * std::cos(y / 23.0) + 2.0 * std::sin(x / 5.0 + y / 7.0) + 0.4 * std::sin(x * 1.3);
}

void scanLanes(mapping::HeightMap& map) {
    for (int column = -120; column < 60; ++column)
        for (int row = -80; row < 80; ++row)
            if (const Vec2 at = map.center_m({column, row}); column < 20 || row > 0)
                map.write({column, row}, static_cast<float>(ground(at.x(), at.y())), {7});
}

std::vector<Vec2> pointsOf(const mapping::CoveragePlan& plan) {
    std::vector<Vec2> points_m;
    for (const mapping::Lane& lane : plan.lanes)
        points_m.insert(points_m.end(), {lane.start_m, lane.end_m});
    return points_m;
}

std::unique_ptr<MapView> world() {
    auto view = std::make_unique<MapView>();
    view->resize(900, 620);
    view->setWorld({{-64.0, -64.0}, {64.0, 64.0}}, QStringLiteral("tall_test"));
    view->setStartPoses(
        {{"PlayerStart", {{0.0, 0.0, 0.0}, 0.0, 0.0, 0.4}}, {"HillTop", {{-40.0, 38.0, 0.0}, 0.0, 0.0, 2.0}}});
    return view;
}

} // namespace

std::unique_ptr<QWidget> mapPage() {
    auto view = world();
    mapping::HeightMap map(0.25);
    scanLanes(map);
    view->heights().take(map.takeChangedTiles(), map.range());
    const Rectangle area{{-30.0, -20.0}, {15.0, 20.0}};
    view->setArea(area);
    view->setAreaSummary(QStringLiteral("9 lanes  ·  6 min 12 s"));
    if (const auto plan = mapping::planCoverage(area, Vec2(0.0, 0.0), {10.0}))
        view->setLanes(pointsOf(*plan));
    for (int i = 0; i < 200; ++i)
        view->setRobot({QStringLiteral("R1"), 1, {{-30.0 + i * 0.2, 10.0 + std::sin(i / 20.0), 6.0}, 0.0, 0.0, 0.1}});
    auto corrected_m = std::make_shared<std::vector<Vec2>>();
    for (int i = 0; i < 200; ++i)
        corrected_m->emplace_back(-29.6 + i * 0.2, 10.5 + std::sin(i / 20.0) - i / 200.0);
    view->setCorrectedPath(QStringLiteral("R1"), corrected_m);
    view->setRobot({QStringLiteral("R2"), 2, {{20.0, -30.0, 0.0}, 0.0, 0.0, 2.6}, true});
    view->setGoal(QStringLiteral("R1"), Vec3(15.0, 10.0, 6.0));
    std::vector<Vec3> hits;
    for (int i = 0; i < 60; ++i)
        hits.emplace_back(9.8, 4.0 + i * 0.2, 0.0);
    view->setLaserHits(QStringLiteral("R1"), hits);
    view->selectRobot(QStringLiteral("R1"));
    int i = 0;
    for (const agent::MarkKind kind : all_mark_kinds)
        view->addMarks(QStringLiteral("R1"), {{kind, Vec3(-26.0 + 5.0 * i++, -8.0, 0.0), Seconds(1.0), {1}}});
    return view;
}

std::unique_ptr<QWidget> areaPage() {
    auto view = world();
    view->setTool(MapTool::Area);
    view->setArea(Rectangle{{-30.0, -20.0}, {30.0, 20.0}});
    view->setAreaSummary(QStringLiteral("6 lanes  ·  4 min 40 s"));
    return view;
}

std::unique_ptr<QWidget> emptyMapPage() {
    auto view = std::make_unique<MapView>();
    view->resize(700, 400);
    return view;
}

std::unique_ptr<QWidget> iconsPage() {
    auto page = std::make_unique<QWidget>();
    auto* grid = new QGridLayout(page.get());
    int i = 0;
    for (const QString& name : iconNames()) {
        auto* picture = new QLabel;
        picture->setPixmap(icon(name).pixmap(32, 32));
        grid->addWidget(picture, i / 8 * 2, i % 8, Qt::AlignCenter);
        grid->addWidget(new QLabel(name), i / 8 * 2 + 1, i % 8, Qt::AlignCenter);
        ++i;
    }
    return page;
}

} // namespace usar::gallery
