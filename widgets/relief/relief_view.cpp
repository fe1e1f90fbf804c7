#include "widgets/relief/relief_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

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

Vec3 pointAt(const Trail& trail, std::size_t i) {
    return {trail.points_m()[i].x(), trail.points_m()[i].y(), trail.heights_m()[i]};
}

/// A trail grows or its last point moves, so there is no need to compare all of them. Neither end is a gap.
bool sameTrail(const std::vector<Vec3>& points_m, const Trail& trail) {
    const std::size_t count = trail.points_m().size();
    return points_m.size() == count &&
           (count == 0 || (points_m.front() == pointAt(trail, 0) && points_m.back() == pointAt(trail, count - 1)));
}

} // namespace

ReliefView::ReliefView(MapView& map, QWidget* parent) : QWidget(parent), map_(map) {
    makeControls();
    empty_state_->setText(tr("No heights yet"), tr("The height map appears here as a surface once a robot has scanned "
                                                   "some ground, a replay plays or a scan is opened."));
    glance_.setInterval(glance_ms);
    connect(&glance_, &QTimer::timeout, this, &ReliefView::look);
    changed_ = map.heights().tiles();
    connect(&map.heights(), &HeightLayer::tilesTaken, this, [this](const auto& tiles) {
        for (const auto& tile : tiles)
            changed_[tile->index] = tile;
    });
    connect(&map.heights(), &HeightLayer::cleared, this, [this] {
        forgets_tiles_ = true;
        changed_.clear();
    });
    connect(&map.heights(), &HeightLayer::changed, this, [this] { heights_changed_ = true; });
    connect(canvas_, &ReliefCanvas::frameWanted, this, &ReliefView::askForFrame);
    connect(canvas_, &ReliefCanvas::movedByUser, this, [this] { follow_->setChecked(false); });
    connect(canvas_, &ReliefCanvas::pointed, this, &ReliefView::showProbe);
    connect(renderer_, &ReliefRenderer::drawn, this, [this](const std::shared_ptr<const ReliefFrame>& frame) {
        if (!map_.heights().empty())
            canvas_->setFrame(frame);
        tellPicture();
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
    save_ = new QToolButton(this);
    makeFlat(save_);
    save_->setFocusPolicy(Qt::StrongFocus);
    save_->hide();
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
    row->addWidget(save_);
    column->addLayout(row);
    column->addWidget(canvas_, 1);
    setTabOrder(all_, follow_);
    setTabOrder(follow_, exaggeration_);
    setTabOrder(exaggeration_, save_);
    setTabOrder(save_, canvas_);
}

void ReliefView::setSaveAction(QAction* save) {
    showAction(save_, save);
    save_->show();
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
    tellPicture();
    if (!isVisible() || !uncovered_)
        return glance_.stop();
    glance_.start();
    look();
}

SharedPoints ReliefView::pointsOf(const QString& robot, const Trail& trail) {
    SharedPoints& points = trail_points_[robot];
    if (points && sameTrail(*points, trail))
        return points;
    auto copied = std::make_shared<std::vector<Vec3>>();
    copied->reserve(trail.points_m().size());
    for (std::size_t i = 0; i < trail.points_m().size(); ++i)
        copied->push_back(pointAt(trail, i));
    return points = std::move(copied);
}

ReliefThings ReliefView::thingsNow() {
    const MapContent& content = map_.content();
    const auto shown = [&content](MapLayer layer) { return content.layer(layer).visible; };
    ReliefThings things;
    things.sky = tokens().raised.rgb();
    things.ground = things.edge_color = tokens().background.rgb();
    things.area_color = tokens().accent.rgb();
    if (content.area.area_in_map && shown(MapLayer::Area))
        things.areas_in_map = {*content.area.area_in_map};
    std::erase_if(trail_points_, [&content](const auto& entry) { return !content.robots.contains(entry.first); });
    for (const auto& [name, robot] : content.robots) {
        const std::uint32_t color = robotColor(robot.robot.number).rgb();
        if (shown(MapLayer::Trails))
            things.trails.push_back({pointsOf(name, robot.trail), color, content.bright(name) ? 2 : 1});
        if (shown(MapLayer::Robots) && robot.robot.base_in_map.position_m.allFinite())
            things.bodies.push_back({.in_map = robot.robot.base_in_map,
                                     .color = robot.robot.stale ? tokens().stale.rgb() : color,
                                     .pointed = !robot.robot.station,
                                     .length_m = robot.robot.footprint ? robot.robot.footprint->length_m : 0.5,
                                     .least_px = content.selected_robot == name ? 26 : 20});
    }
    if (shown(MapLayer::Marks))
        for (const auto& [name, marks] : content.marks)
            for (const agent::MapMark& mark : marks)
                if (mark.kind != agent::MarkKind::Path && mark.position_in_map_m.allFinite())
                    things.bodies.push_back(mapping::markBody(mark.position_in_map_m, markColor(mark.kind).rgb(), 12));
    return things;
}

std::vector<ReliefCanvas::Label> ReliefView::labelsNow() const {
    const MapContent& content = map_.content();
    std::vector<ReliefCanvas::Label> labels;
    if (!content.layer(MapLayer::Robots).visible)
        return labels;
    for (const auto& [name, robot] : content.robots) {
        Vec3 place_m = robot.robot.base_in_map.position_m;
        if (!place_m.allFinite())
            continue;
        if (const auto ground = map_.heights().probe(place_m.head<2>())) // The body is drawn on it, too.
            place_m.z() = std::max(place_m.z(), double(ground->height_m));
        labels.push_back({name, place_m});
    }
    return labels;
}

void ReliefView::tellPicture() {
    const bool has = hasPicture();
    if (std::exchange(had_picture_, has) != has)
        emit hasPictureChanged();
}

void ReliefView::look() {
    if (!glance_.isActive())
        return;
    const bool empty = map_.heights().empty();
    empty_state_->setVisible(empty);
    if (empty)
        canvas_->setFrame(nullptr);
    tellPicture();
    canvas_->setLabels(labelsNow());
    const MapRobot* const selected = map_.content().selectedRobot();
    follow_->setEnabled(selected);
    if (selected && follow_->isChecked())
        canvas_->lookAt(selected->base_in_map.position_m);
    if (heights_changed_ || thingsNow() != asked_)
        askForFrame();
}

void ReliefView::askForFrame() {
    if (!glance_.isActive() || map_.heights().empty())
        return;
    const HeightStyle& style = map_.heights().style();
    heights_changed_ = false;
    asked_ = thingsNow();
    ReliefRequest request;
    request.forgets_tiles = std::exchange(forgets_tiles_, false);
    request.changed = std::exchange(changed_, {});
    request.cell_size_m = map_.heights().cellSize_m();
    request.style = {style.range, style.color_map, style.contour_step_m};
    request.things = asked_;
    request.camera = canvas_->camera();
    request.exaggeration = canvas_->exaggeration();
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
