#include "widgets/map/map_view.h"

#include <cmath>
#include <utility>

#include "widgets/map/map_accessible.h"
#include "widgets/map/map_overlay.h"
#include "widgets/map/map_painter.h"
#include "widgets/map/measure_painter.h"

namespace usar::widgets {

namespace {

// Longer than the pages of a scan need, shorter than anybody sees.
constexpr int one_cycle_ms = 30;

} // namespace

MapView::MapView(QWidget* parent) : QWidget(parent) {
    describeMaps();
    setFocusPolicy(Qt::StrongFocus);
    setAttribute(Qt::WA_OpaquePaintEvent);
    setAccessibleName(tr("Map"));
    setAccessibleDescription(tr("Arrow keys pan, plus and minus zoom, N walks over the start poses, Return spawns."));
    empty_state_->setText(
        tr("No world yet"),
        tr("The world, its start poses and the height map appear here once a server answers or a replay plays."));
    soon_.setSingleShot(true);
    soon_.setInterval(one_cycle_ms);
    connect(&soon_, &QTimer::timeout, this, &MapView::paintChanges);
    connect(heights_, &HeightLayer::groundChanged, this,
            [this](const Rectangle& ground_in_map) { changes_.touch(ground_in_map); });
    connect(heights_, &HeightLayer::changed, this, &MapView::paintSoon);
    way_back_->setToolTip(tr("Nothing of the world is in sight here; shows all of it again"));
    way_back_->hide();
    connect(way_back_, &QPushButton::clicked, this, [this] {
        setFocus(); // The button goes; keys go on to the map.
        fitWorld();
    });
    connect(&gestures_, &MapGestures::panned, this, &MapView::panBy);
    connect(&gestures_, &MapGestures::startPoseClicked, this, &MapView::askAbout);
    connect(&gestures_, &MapGestures::spawnRequested, this, &MapView::spawnRequested);
    connect(&gestures_, &MapGestures::lineMeasured, this, [this](const MeasuredLine& line) {
        setAccessibleDescription(tr("Measured: %1").arg(measuredText(line, *heights_)));
    });
    showContent();
}

void MapView::setWorld(const Rectangle& extent_in_map, const QString& name, const SceneryPtr& scenery) {
    content_.world_in_map = extent_in_map;
    content_.world_name = name;
    content_.scenery = scenery;
    fitWorld();
    showContent();
}

void MapView::setBackground(const QImage& image, const Rectangle& image_in_map) {
    content_.background = image;
    content_.background_in_map = image_in_map;
    update();
}

void MapView::setStartPoses(const std::vector<protocol::StartPose>& poses) {
    content_.start_poses = poses;
    content_.hot_start_pose.reset();
    if (!content_.world_in_map && shown_ == Shown::World)
        fitWorld();
    update();
    showContent();
}

void MapView::clear() {
    content_.forgetServer();
    gestures_.forget();
    heights_->clear(heights_->cellSize_m());
    traces_.clear();
    shown_ = Shown::World;
    setFollowing(false);
    showContent();
}

void MapView::setArea(const std::optional<Rectangle>& area_in_map) {
    put(content_.area.area_in_map, area_in_map && !area_in_map->empty() ? area_in_map : std::nullopt);
}

void MapView::setRobot(const MapRobot& robot) {
    content_.takeRobot(robot);
    const Vec2 at = robot.base_in_map.position_m.head<2>();
    if (following_ && robot.name == content_.selected_robot && at.allFinite())
        transform_.center_m = at;
    showContent();
}

void MapView::removeRobot(const QString& name) {
    content_.robots.erase(name);
    content_.marks.erase(name);
    if (content_.selected_robot == name)
        selectRobot({});
    update();
    showContent();
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
    paintSoon();
}

void MapView::setCorrectedPath(const QString& robot, const SharedPath& path_in_map_m) {
    if (const auto found = content_.robots.find(robot); found != content_.robots.end())
        put(found->second.corrected_in_map_m, path_in_map_m);
}

void MapView::setLaserHits(const QString& robot, const std::vector<Vec3>& hits_in_map_m) {
    if (const auto found = content_.robots.find(robot); found != content_.robots.end())
        found->second.hits_in_map_m = hits_in_map_m;
    paintSoon();
}

void MapView::addMarks(const QString& robot, const std::vector<agent::MapMark>& marks) {
    if (marks.empty())
        return;
    std::vector<agent::MapMark>& of_robot = content_.marks[robot];
    of_robot.insert(of_robot.end(), marks.begin(), marks.end());
    paintSoon();
}

void MapView::clearMarks(const QString& robot) {
    content_.marks.erase(robot);
    update();
}

void MapView::setRobotArea(const QString& robot, const Rectangle& area_in_map) {
    if (const auto found = content_.robots.find(robot); found != content_.robots.end())
        put(found->second.area_in_map, area_in_map);
}

void MapView::selectRobot(const QString& name) {
    content_.selected_robot = name;
    if (name.isEmpty())
        setFollowing(false);
    update();
}

void MapView::setObjects(const std::vector<MapObject>& objects) {
    if (content_.objects.objects == objects)
        return;
    content_.setObjects(objects);
    update();
}

void MapView::addTraceMark(const Vec2& point_in_map_m, const QColor& color) {
    traces_.add(point_in_map_m, color);
    update();
}

void MapView::clearTraceMarks() {
    traces_.clear();
    update();
}

void MapView::setLayer(MapLayer layer, const LayerState& state) {
    put(content_.layers[static_cast<std::size_t>(layer)], state);
    if (layer == MapLayer::Contours)
        heights_->setContours(state.visible);
}

void MapView::setOrientation(MapOrientation orientation) {
    transform_.orientation = orientation;
    heights_->setOrientation(orientation);
    fit();
}

void MapView::setTransform(const MapTransform& transform) {
    transform_.center_m = transform.center_m;
    transform_.pixels_per_m = transform.pixels_per_m;
    shown_ = Shown::Chosen;
    moved();
}

void MapView::fit(const std::optional<Vec2>& wanted_in_map_m) {
    Rectangle mission = content_.missionInMap(heights_->bounds_in_map());
    if (mission.empty())
        return fitWorld();
    if (wanted_in_map_m)
        mission = {mission.min_m.cwiseMin(*wanted_in_map_m), mission.max_m.cwiseMax(*wanted_in_map_m)};
    transform_.fitClearOf(mission, OverlayPlaces(legendsOfAMission(content_), transform_).all(), 48.0);
    shown_ = Shown::Mission;
    wanted_m_ = wanted_in_map_m;
    moved();
}

void MapView::fitWorld() {
    transform_.fit(content_.groundInMap());
    shown_ = Shown::World;
    moved();
}

void MapView::zoomAt(const QPointF& at_px, double factor) {
    transform_.zoomAt(at_px, factor);
    shown_ = Shown::Chosen;
    moved();
}

void MapView::panBy(const QPointF& by_px) {
    transform_.pan(by_px);
    shown_ = Shown::Chosen;
    setFollowing(false);
}

void MapView::moved() {
    showWayBack();
    update();
}

void MapView::showWayBack() {
    const auto all = content_.everythingInMap(heights_->bounds_in_map());
    const Rectangle seen = transform_.visible();
    const bool in_sight =
        !all || ((all->min_m.array() <= seen.max_m.array()).all() && (all->max_m.array() >= seen.min_m.array()).all());
    if (!in_sight) {
        const QSize size = way_back_->sizeHint();
        way_back_->setGeometry(QRect(rect().center() - QPoint(size.width() / 2, size.height() / 2), size));
    }
    if (way_back_->isHidden() != in_sight)
        way_back_->setHidden(in_sight);
}

void MapView::setFollowing(bool following) {
    const MapRobot* const robot = content_.selectedRobot();
    following = following && robot;
    if (following) {
        shown_ = Shown::Chosen;
        transform_.center_m = robot->base_in_map.position_m.head<2>();
    }
    if (following != following_) {
        following_ = following;
        emit followingChanged(following);
    }
    moved();
}

void MapView::showContent() {
    empty_state_->setVisible(content_.empty());
    showWayBack();
    paintSoon();
}

void MapView::paintSoon() {
    if (!soon_.isActive())
        soon_.start();
}

void MapView::paintChanges() {
    const std::optional<QRegion> changed_px = changes_.take(content_, *heights_, overlay(), transform_);
    const QRegion late_px = std::exchange(late_px_, {});
    // With a fractional scale of the screen, the edges of a part lie between its pixels.
    const bool parts_are_sharp = devicePixelRatioF() == std::floor(devicePixelRatioF());
    if (changed_px && parts_are_sharp && empty_state_->isHidden())
        update(*changed_px | late_px);
    else
        update();
}

MapOverlay MapView::overlay() const {
    MapOverlay overlay;
    overlay.focused = hasFocus() && focusWidget() == this;
    if (following_)
        overlay.following = content_.selected_robot;
    if (const auto& cursor_px = gestures_.cursor_px()) {
        const Vec2 at = transform_.toMap(*cursor_px);
        const bool tell_whose = scanned_by_ && content_.robots.size() > 1;
        overlay.probe = probeText(at, heights_->probe(at), tell_whose ? scanned_by_(at) : QStringList(),
                                  age_of_ ? age_of_(at) : std::nullopt);
    }
    return overlay;
}

void MapView::paintEvent(QPaintEvent* event) {
    QPainter painter(this);
    if (!empty_state_->isHidden())
        return painter.fillRect(rect(), tokens().background);
    const MapOverlay shown = overlay();
    const QRegion elsewhere = QRegion(rect()) - event->region();
    const std::optional<QRegion> changed_px = changes_.take(content_, *heights_, shown, transform_);
    // The content may have changed since this part was asked for, elsewhere too.
    if (const QRegion late_px = changed_px ? *changed_px & elsewhere : elsewhere; !late_px.isEmpty()) {
        late_px_ |= late_px;
        paintSoon();
    }
    for (const QRect& part_px : apart(event->region())) {
        painter.setClipRect(part_px);
        ground_.paint(painter, content_, transform_);
        MapPainter(painter, content_, *heights_, traces_, transform_, changes_.labels(), part_px).paintLayers();
        if (content_.measured)
            paintMeasured(painter, *content_.measured, *heights_, transform_);
        paintOverlay(painter, shown, content_, *heights_, transform_, part_px);
    }
}

void MapView::resizeEvent(QResizeEvent* event) {
    transform_.viewport = QSizeF(size());
    switch (shown_) {
    case Shown::World:
        fitWorld();
        break;
    case Shown::Mission:
        fit(wanted_m_);
        break;
    case Shown::Chosen:
        moved();
        break;
    }
    QWidget::resizeEvent(event);
}

} // namespace usar::widgets
