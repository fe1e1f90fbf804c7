#include "widgets/map/map_view.h"

#include <QEvent>

#include "widgets/map/map_overlay.h"
#include "widgets/map/map_painter.h"
#include "widgets/models/figures.h"
#include "widgets/style/empty_state.h"

namespace usar::widgets {

MapView::MapView(QWidget* parent)
    : QWidget(parent)
    , heights_(new HeightLayer(this))
    , empty_state_(new EmptyState(this)) {
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setAcceptDrops(true);
    setAttribute(Qt::WA_OpaquePaintEvent);
    setAccessibleName(tr("Map"));
    setAccessibleDescription(tr("Arrow keys pan, plus and minus zoom, N walks over the start poses, Return spawns."));
    empty_state_->setText(tr("No world yet"),
                          tr("The world, its start poses and the height map appear here once a server answers."));
    connect(heights_, &HeightLayer::changed, this, qOverload<>(&QWidget::update));
    updateEmptyState();
}

MapView::~MapView() = default;

void MapView::setWorld(const Rectangle& extent_in_map, const QString& name) {
    content_.world_in_map = extent_in_map;
    content_.world_name = name;
    view_touched_ = false;
    fitWorld();
    updateEmptyState();
}

void MapView::setBackground(const QImage& image, const Rectangle& image_in_map) {
    content_.background = image;
    content_.background_in_map = image_in_map;
    update();
}

void MapView::setStartPoses(const std::vector<protocol::StartPose>& poses) {
    content_.start_poses = poses;
    content_.hot_start_pose.reset();
    if (!content_.world_in_map && !view_touched_)
        fitWorld();
    updateEmptyState();
    update();
}

void MapView::clear() {
    const auto layers = content_.layers;
    const bool editing = content_.area.editing;
    content_ = {};
    content_.layers = layers;
    content_.area.editing = editing;
    cancelGesture();
    heights_->clear(heights_->cellSize_m());
    traces_.clear();
    view_touched_ = false;
    setFollowing(false);
    updateEmptyState();
    update();
}

void MapView::clearHeights(double cell_size_m) {
    heights_->clear(cell_size_m);
}

void MapView::takeTiles(const std::vector<std::shared_ptr<const mapping::HeightTile>>& tiles,
                        const std::optional<mapping::HeightRange>& range) {
    heights_->take(tiles, range);
}

void MapView::setColorMap(mapping::ColorMap color_map) {
    heights_->setColorMap(color_map);
    update();
}

void MapView::setArea(const std::optional<Rectangle>& area_in_map) {
    content_.area.area_in_map = area_in_map && !area_in_map->empty() ? area_in_map : std::nullopt;
    update();
}

void MapView::setAreaSummary(const QString& summary) {
    content_.area.summary = summary;
    update();
}

void MapView::setLanes(const std::vector<Vec2>& points_in_map_m) {
    content_.area.lanes_in_map_m = points_in_map_m;
    update();
}

void MapView::setLanes(const mapping::CoveragePlan& plan) {
    std::vector<Vec2> points;
    points.reserve(2 * plan.lanes.size());
    for (const mapping::Lane& lane : plan.lanes) {
        points.push_back(lane.start_m);
        points.push_back(lane.end_m);
    }
    setLanes(points);
}

void MapView::setRobot(const MapRobot& robot) {
    RobotOnMap& on_map = content_.robots[robot.name];
    on_map.robot = robot;
    const Vec2 at = robot.base_in_map.position_m.head<2>();
    if (!robot.stale)
        on_map.trail.add(at);
    if (following_ && robot.name == content_.selected_robot && at.allFinite())
        transform_.center_m = at;
    updateEmptyState();
    update();
}

void MapView::removeRobot(const QString& name) {
    content_.robots.erase(name);
    if (content_.selected_robot == name)
        selectRobot({});
    updateEmptyState();
    update();
}

void MapView::setRadioLinks(const std::vector<RadioLink>& links) {
    if (links == content_.radio_links)
        return;
    content_.radio_links = links;
    if (layer(MapLayer::Radio).visible)
        update();
}

void MapView::setGoal(const QString& robot, const std::optional<Vec3>& goal_in_map_m) {
    if (const auto found = content_.robots.find(robot); found != content_.robots.end())
        found->second.goal_in_map_m = goal_in_map_m;
    update();
}

void MapView::setLaserHits(const QString& robot, const std::vector<Vec3>& hits_in_map_m) {
    if (const auto found = content_.robots.find(robot); found != content_.robots.end())
        found->second.hits_in_map_m = hits_in_map_m;
    update();
}

void MapView::addMark(const agent::MapMark& mark) {
    content_.marks.push_back(mark);
    update();
}

void MapView::clearMarks() {
    content_.marks.clear();
    update();
}

void MapView::clearTraces() {
    content_.marks.clear();
    for (auto& [name, robot] : content_.robots) {
        robot.trail.clear();
        robot.hits_in_map_m.clear();
        robot.goal_in_map_m.reset();
    }
    update();
}

void MapView::selectRobot(const QString& name) {
    content_.selected_robot = name;
    if (name.isEmpty())
        setFollowing(false);
    update();
}

void MapView::setLayer(MapLayer layer, const LayerState& state) {
    content_.layers[static_cast<std::size_t>(layer)] = state;
    update();
}

void MapView::setTool(MapTool tool) {
    if (tool == tool_)
        return;
    cancelGesture();
    tool_ = tool;
    content_.area.editing = tool == MapTool::Area;
    content_.area.hot_grip.reset();
    showGhost(cursor_px_);
    updateCursor();
    emit toolChanged(tool);
    update();
}

void MapView::setOrientation(MapOrientation orientation) {
    transform_.orientation = orientation;
    heights_->setOrientation(orientation);
    fit();
}

void MapView::setTransform(const MapTransform& transform) {
    transform_.center_m = transform.center_m;
    transform_.pixels_per_m = transform.pixels_per_m;
    view_touched_ = true;
    update();
}

void MapView::fit() {
    Rectangle seen = heights_->bounds_in_map();
    if (const auto& area = content_.area.area_in_map)
        seen = seen.empty() ? *area : Rectangle{seen.min_m.cwiseMin(area->min_m), seen.max_m.cwiseMax(area->max_m)};
    if (seen.empty())
        return fitWorld();
    transform_.fit(seen, 48.0);
    view_touched_ = true;
    update();
}

void MapView::fitWorld() {
    if (content_.world_in_map) {
        transform_.fit(*content_.world_in_map);
    } else if (!content_.start_poses.empty()) {
        Rectangle around{content_.start_poses.front().pose_in_map.position_m.head<2>(), Vec2::Zero()};
        around.max_m = around.min_m;
        for (const auto& pose : content_.start_poses) {
            around.min_m = around.min_m.cwiseMin(pose.pose_in_map.position_m.head<2>());
            around.max_m = around.max_m.cwiseMax(pose.pose_in_map.position_m.head<2>());
        }
        transform_.fit({around.min_m - Vec2(20.0, 20.0), around.max_m + Vec2(20.0, 20.0)});
    }
    update();
}

void MapView::zoomIn() {
    transform_.zoomAt(QRectF(rect()).center(), 1.25);
    view_touched_ = true;
    update();
}

void MapView::zoomOut() {
    transform_.zoomAt(QRectF(rect()).center(), 0.8);
    view_touched_ = true;
    update();
}

void MapView::setFollowing(bool following) {
    const auto robot = content_.robots.find(content_.selected_robot);
    following = following && robot != content_.robots.end();
    if (following)
        transform_.center_m = robot->second.robot.base_in_map.position_m.head<2>();
    if (following != following_) {
        following_ = following;
        emit followingChanged(following);
    }
    update();
}

void MapView::updateEmptyState() {
    empty_state_->setVisible(!content_.world_in_map && content_.start_poses.empty() && content_.robots.empty());
}

void MapView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), tokens().background);
    if (!empty_state_->isHidden())
        return;
    MapPainter(painter, content_, *heights_, traces_, transform_).paintLayers();
    MapOverlay overlay;
    overlay.focused = hasFocus() && focusWidget() == this;
    if (following_)
        overlay.following = content_.selected_robot;
    if (cursor_px_) {
        const Vec2 at = transform_.toMap(*cursor_px_);
        const auto probe = heights_->probe(at);
        overlay.probe = QStringLiteral("x %1   y %2   z %3 m   hits %4")
                            .arg(figure(at.x(), 1, 6), figure(at.y(), 1, 6),
                                 probe ? figure(double(probe->height_m), 2, 6) : figure(qQNaN(), 2, 6),
                                 figure(probe ? double(probe->hits) : qQNaN(), 0, 3));
    }
    paintOverlay(painter, overlay, content_, *heights_, transform_);
}

void MapView::resizeEvent(QResizeEvent* event) {
    transform_.viewport = QSizeF(size());
    if (!view_touched_)
        fitWorld();
    QWidget::resizeEvent(event);
}

void MapView::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange)
        update();
    QWidget::changeEvent(event);
}

} // namespace usar::widgets
