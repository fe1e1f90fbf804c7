#include "widgets/relief/relief_view.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <QBoxLayout>
#include <QJsonArray>
#include <QSignalBlocker>

#include "widgets/map/map_overlay.h"
#include "widgets/models/figures.h"
#include "widgets/style/theme.h"
#include "widgets/style/tool_button.h"

namespace usar::widgets {

namespace {

constexpr int glance_ms = 50;
constexpr std::array exaggerations{1.0, 1.5, 2.0, 3.0, 5.0};

std::vector<Vec3> pointsOf(const Trail& trail) {
    std::vector<Vec3> points;
    points.reserve(trail.points_m().size());
    for (std::size_t i = 0; i < trail.points_m().size(); ++i)
        points.emplace_back(trail.points_m()[i].x(), trail.points_m()[i].y(), trail.heights_m()[i]);
    return points;
}

/// NaN in gaps is the same as NaN.
bool samePoints(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    return std::ranges::equal(
        a, b, [](const Vec3& one, const Vec3& other) { return one == other || (one.hasNaN() && other.hasNaN()); });
}

bool sameThings(const mapping::ReliefScene& a, const mapping::ReliefScene& b) {
    const auto same_line = [](const mapping::ReliefLine& one, const mapping::ReliefLine& other) {
        return one.color == other.color && one.width_px == other.width_px &&
               samePoints(one.points_in_map_m, other.points_in_map_m);
    };
    return std::ranges::equal(a.lines, b.lines, same_line) && a.bodies == b.bodies && a.sky == b.sky &&
           a.ground == b.ground;
}

mapping::ReliefBody markBody(const agent::MapMark& mark) {
    return {.in_map = {mark.position_in_map_m, 0.0, 0.0, 0.0},
            .color = markColor(mark.kind).rgb(),
            .pointed = false,
            .length_m = 0.3,
            .least_px = 12,
            .stalk = false};
}

} // namespace

ReliefView::ReliefView(MapView& map, QWidget* parent) : QWidget(parent), map_(map) {
    makeControls();
    empty_state_->setText(tr("No heights yet"), tr("The height map appears here as a surface once a robot has scanned "
                                                   "some ground, a replay plays or a scan is opened."));
    glance_.setInterval(glance_ms);
    connect(&glance_, &QTimer::timeout, this, &ReliefView::look);
    connect(&map.heights(), &HeightLayer::changed, this, [this] { heights_changed_ = true; });
    connect(canvas_, &ReliefCanvas::frameWanted, this, &ReliefView::askForFrame);
    connect(canvas_, &ReliefCanvas::movedByUser, this, [this] { follow_->setChecked(false); });
    connect(canvas_, &ReliefCanvas::pointed, this, &ReliefView::showProbe);
    connect(renderer_, &ReliefRenderer::drawn, this, [this](const std::shared_ptr<const ReliefFrame>& frame) {
        if (!map_.heights().empty())
            canvas_->setFrame(frame);
    });
    onThemeChange(this, [this] { heights_changed_ = true; });
}

void ReliefView::makeControls() {
    all_ = makeToolButton(tr("Show all heights (Home)"), this, QStringLiteral("fit"));
    connect(all_, &QToolButton::clicked, this, [this] {
        follow_->setChecked(false);
        canvas_->showAll();
    });
    follow_ = makeToolButton(tr("Keep the selected robot in the middle"), this, QStringLiteral("follow"));
    follow_->setCheckable(true);
    connect(follow_, &QToolButton::toggled, this, [this](bool on) {
        canvas_->keepTarget(on);
        look();
    });
    named(exaggeration_, tr("Height exaggeration"), tr("How many times as high as they are heights are drawn"));
    exaggeration_->setMinimumHeight(minimum_target);
    for (const double factor : exaggerations)
        exaggeration_->addItem(tr("Heights × %1").arg(factor), factor);
    connect(exaggeration_, &QComboBox::currentIndexChanged, this,
            [this] { canvas_->setExaggeration(exaggeration_->currentData().toDouble()); });
    auto* const column = laidOut(new QVBoxLayout(this), {}, 0);
    auto* const row = laidOut(new QHBoxLayout, {gap::tiny, gap::tiny, gap::tiny, gap::tiny}, gap::tiny,
                              {all_, follow_, exaggeration_});
    row->addStretch(1);
    column->addLayout(row);
    column->addWidget(canvas_, 1);
    setTabOrder(all_, follow_);
    setTabOrder(follow_, exaggeration_);
    setTabOrder(exaggeration_, canvas_);
}

void ReliefView::setUncovered(bool uncovered) {
    uncovered_ = uncovered;
    watchedOrNot();
}

void ReliefView::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    watchedOrNot();
}

void ReliefView::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    watchedOrNot();
}

void ReliefView::watchedOrNot() {
    if (!isVisible() || !uncovered_)
        return glance_.stop();
    glance_.start();
    look();
}

mapping::ReliefScene ReliefView::sceneNow() const {
    const MapContent& content = map_.content();
    const auto shown = [&content](MapLayer layer) { return content.layer(layer).visible; };
    mapping::ReliefScene scene;
    scene.camera = canvas_->camera();
    scene.exaggeration = canvas_->exaggeration();
    scene.sky = tokens().raised.rgb();
    scene.ground = tokens().background.rgb();
    const std::uint32_t edge = tokens().background.rgb();
    for (const auto& [name, robot] : content.robots) {
        const std::uint32_t color = robotColor(robot.robot.number).rgb();
        if (shown(MapLayer::Trails))
            scene.lines.push_back({pointsOf(robot.trail), color, edge, content.bright(name) ? 2 : 1});
        if (shown(MapLayer::Robots) && robot.robot.base_in_map.position_m.allFinite())
            scene.bodies.push_back({.in_map = robot.robot.base_in_map,
                                    .color = robot.robot.stale ? tokens().stale.rgb() : color,
                                    .pointed = !robot.robot.station,
                                    .length_m = robot.robot.footprint ? robot.robot.footprint->length_m : 0.5,
                                    .least_px = content.selected_robot == name ? 26 : 20});
    }
    if (shown(MapLayer::Marks))
        for (const auto& [name, marks] : content.marks)
            for (const agent::MapMark& mark : marks)
                if (mark.kind != agent::MarkKind::Path && mark.position_in_map_m.allFinite())
                    scene.bodies.push_back(markBody(mark));
    return scene;
}

std::vector<Rectangle> ReliefView::areasNow() const {
    const MapContent& content = map_.content();
    if (!content.area.area_in_map || !content.layer(MapLayer::Area).visible)
        return {};
    return {*content.area.area_in_map};
}

void ReliefView::look() {
    if (!glance_.isActive())
        return;
    const MapContent& content = map_.content();
    const bool empty = map_.heights().empty();
    empty_state_->setVisible(empty);
    if (empty)
        canvas_->setFrame(nullptr);
    std::vector<ReliefCanvas::Label> labels;
    if (content.layer(MapLayer::Robots).visible)
        for (const auto& [name, robot] : content.robots)
            if (robot.robot.base_in_map.position_m.allFinite())
                labels.push_back({name, robot.robot.base_in_map.position_m});
    canvas_->setLabels(labels);
    const MapRobot* const selected = content.selectedRobot();
    follow_->setEnabled(selected);
    if (selected && follow_->isChecked())
        canvas_->lookAt(selected->base_in_map.position_m);
    if (heights_changed_ || areasNow() != asked_areas_ || !sameThings(sceneNow(), asked_))
        askForFrame();
}

void ReliefView::askForFrame() {
    if (!glance_.isActive() || map_.heights().empty())
        return;
    const HeightLayer& heights = map_.heights();
    heights_changed_ = false;
    asked_ = sceneNow();
    asked_areas_ = areasNow();
    ReliefRequest request;
    request.tiles = heights.tiles();
    request.cell_size_m = heights.cellSize_m();
    request.style = {heights.style().range, heights.style().color_map, heights.style().contour_step_m};
    request.scene = asked_;
    request.areas_in_map = asked_areas_;
    request.area_color = tokens().accent.rgb();
    request.edge_color = tokens().background.rgb();
    request.show_all = canvas_->showsAll();
    request.size_px = canvas_->wantedSize_px();
    renderer_->draw(std::move(request));
}

void ReliefView::showProbe(const std::optional<Vec3>& point_in_map_m) {
    if (!point_in_map_m)
        return canvas_->setProbe({});
    const Vec2 at_m = point_in_map_m->head<2>();
    canvas_->setProbe(probeText(at_m, map_.heights().probe(at_m)));
}

QJsonObject ReliefView::state() const {
    const mapping::OrbitCamera& camera = canvas_->camera();
    QJsonObject state{{"yaw_deg", degrees(camera.yaw_rad)},
                      {"elevation_deg", degrees(camera.elevation_rad)},
                      {"exaggeration", canvas_->exaggeration()},
                      {"follow", following()}};
    if (!canvas_->showsAll()) {
        const Vec3& target_m = camera.target_in_map_m;
        state["target_m"] = QJsonArray{target_m.x(), target_m.y(), target_m.z()};
        state["distance_m"] = camera.distance_m;
    }
    return state;
}

void ReliefView::setState(const QJsonObject& state) {
    if (state.isEmpty())
        return;
    mapping::OrbitCamera camera = canvas_->camera();
    camera.yaw_rad = radians(state["yaw_deg"].toDouble(degrees(camera.yaw_rad)));
    camera.elevation_rad = radians(state["elevation_deg"].toDouble(degrees(camera.elevation_rad)));
    const QJsonArray target = state["target_m"].toArray();
    const bool has_place = target.size() == 3 && std::all_of(target.begin(), target.end(),
                                                             [](const QJsonValue& value) { return value.isDouble(); });
    const bool showed_all = canvas_->showsAll();
    if (has_place) {
        camera.target_in_map_m = {target[0].toDouble(), target[1].toDouble(), target[2].toDouble()};
        camera.distance_m = state["distance_m"].toDouble(camera.distance_m);
    }
    canvas_->setCamera(camera);
    if (!has_place && (showed_all || !state.contains("target_m")))
        canvas_->showAll();
    if (const int row = exaggeration_->findData(state["exaggeration"].toDouble()); row >= 0)
        exaggeration_->setCurrentIndex(row);
    follow_->setChecked(state["follow"].toBool(following()));
}

} // namespace usar::widgets
