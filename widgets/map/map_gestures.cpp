#include "widgets/map/map_gestures.h"

#include <cmath>
#include <utility>

#include <QApplication>
#include <QMimeData>

#include "widgets/models/figures.h"

namespace usar::widgets {

namespace {

/// Returns why no area can be drawn between these two corners; empty if it can.
QString refusal(const Vec2& from_m, const Vec2& to_m, const std::optional<Rectangle>& world) {
    if (spanned(from_m, to_m, std::nullopt).empty())
        return MapGestures::tr("The drawn area has no size. Drag from one corner to the opposite one.");
    if (!world || !spanned(from_m, to_m, world).empty())
        return {};
    return MapGestures::tr("The drawn area lies outside the world, which spans x %1 … %2 m and y %3 … %4 m. Draw it "
                           "inside the world's frame.")
        .arg(figure(world->min_m.x(), 1), figure(world->max_m.x(), 1), figure(world->min_m.y(), 1),
             figure(world->max_m.y(), 1));
}

} // namespace

MapGestures::MapGestures(QWidget& widget, MapContent& content, const MapTransform& transform)
    : widget_(widget)
    , content_(content)
    , transform_(transform) {
    widget.setMouseTracking(true);
    widget.setAcceptDrops(true);
    widget.installEventFilter(this);
}

void MapGestures::setTool(MapTool tool) {
    if (tool == tool_)
        return;
    cancel();
    tool_ = tool;
    content_.measured.reset();
    content_.area.editing = tool == MapTool::Area;
    content_.area.hot_grip.reset();
    showGhost(cursor_px_);
    updateCursor();
    emit toolChanged(tool);
}

void MapGestures::setGhost(const std::optional<MapObject>& ghost) {
    ghost_ = ghost;
    showGhost(cursor_px_);
}

void MapGestures::showGhost(const std::optional<QPointF>& at_px) {
    content_.objects.ghost.reset();
    if (ghost_ && at_px && (tool_ == MapTool::Place || dragged_in_))
        content_.objects.ghost = movedTo(*ghost_, transform_.toMap(*at_px));
    widget_.update();
}

bool MapGestures::eventFilter(QObject* watched, QEvent* event) {
    if (watched == &widget_ && widget_.isEnabled() && (takeMouse(event) || takeDrag(event)))
        return true;
    return QObject::eventFilter(watched, event);
}

bool MapGestures::takeMouse(QEvent* event) {
    switch (event->type()) {
    case QEvent::MouseButtonPress:
        return press(*static_cast<QMouseEvent*>(event)), true;
    case QEvent::MouseMove:
        return move(static_cast<QMouseEvent*>(event)->position(), static_cast<QMouseEvent*>(event)->modifiers()), true;
    case QEvent::MouseButtonRelease:
        return release(*static_cast<QMouseEvent*>(event)), true;
    case QEvent::MouseButtonDblClick:
        return doubleClick(*static_cast<QMouseEvent*>(event)), true;
    case QEvent::Leave:
        return leave(), true;
    default:
        return false;
    }
}

bool MapGestures::takeDrag(QEvent* event) {
    switch (event->type()) {
    case QEvent::DragEnter:
        return dragIn(*static_cast<QDropEvent*>(event)), true;
    case QEvent::DragMove:
        showGhost(static_cast<QDropEvent*>(event)->position());
        event->setAccepted(dragged_in_);
        return true;
    case QEvent::DragLeave:
        dragged_in_ = false;
        return showGhost({}), true;
    case QEvent::Drop:
        return drop(*static_cast<QDropEvent*>(event)), true;
    default:
        return false;
    }
}

void MapGestures::press(const QMouseEvent& event) {
    pressed_px_ = last_px_ = event.position();
    pressed_m_ = transform_.toMap(pressed_px_);
    if (event.button() == Qt::MiddleButton || event.button() == Qt::RightButton)
        gesture_ = Gesture::Panning;
    else if (event.button() == Qt::LeftButton)
        gesture_ = Gesture::Pressed;
    if (gesture_ == Gesture::Pressed && tool_ == MapTool::Robot) {
        gesture_ = Gesture::PlacingRobot;
        draft_before_ = content_.spawn_draft_in_map;
        setDraft(Pose{Vec3(pressed_m_.x(), pressed_m_.y(), 0.0)});
    }
    if (gesture_ == Gesture::Pressed && tool_ == MapTool::Measure) {
        gesture_ = Gesture::Measuring;
        content_.measured = {pressed_m_, pressed_m_};
    }
    updateCursor();
}

void MapGestures::move(const QPointF& at_px, Qt::KeyboardModifiers modifiers) {
    cursor_px_ = at_px;
    const QPointF way = at_px - pressed_px_;
    if (gesture_ == Gesture::Pressed && std::hypot(way.x(), way.y()) >= QApplication::startDragDistance() / 2.0)
        beginDrag();
    if (gesture_ == Gesture::Panning)
        emit panned(at_px - last_px_);
    else if (gesture_ == Gesture::DraggingArea)
        dragArea(at_px);
    else if (gesture_ == Gesture::DraggingObject)
        content_.objects.held_to_m = held_from_m_ + transform_.toMap(at_px) - pressed_m_;
    else if (gesture_ == Gesture::PlacingRobot)
        turnDraft(at_px);
    else if (gesture_ == Gesture::Measuring)
        content_.measured = {pressed_m_, transform_.toMap(at_px), modifiers.testFlag(Qt::ShiftModifier)};
    else
        hover(at_px);
    updateCursor();
    showGhost(at_px);
    last_px_ = at_px;
}

void MapGestures::release(const QMouseEvent& event) {
    const Gesture gesture = std::exchange(gesture_, Gesture::None);
    if (gesture == Gesture::Pressed)
        click(event.position(), event.modifiers());
    else if (gesture == Gesture::DraggingObject)
        finishObjectDrag();
    else if (gesture == Gesture::DraggingArea)
        finishAreaDrag(event.position());
    else if (gesture == Gesture::PlacingRobot)
        finishPlacing();
    else if (gesture == Gesture::Measuring)
        finishMeasuring();
    updateCursor();
    widget_.update();
}

void MapGestures::doubleClick(const QMouseEvent& event) {
    // No gesture begins, so that the second release does not count as a click.
    if (event.button() != Qt::LeftButton || clickWithTool(event.position(), event.modifiers()))
        return;
    if (const auto pose = hits().startPoseAt(event.position()))
        emit spawnRequested(static_cast<int>(*pose));
}

void MapGestures::leave() {
    cursor_px_.reset();
    content_.hot_start_pose.reset();
    content_.area.hot_grip.reset();
    showGhost({});
}

void MapGestures::dragIn(QDropEvent& event) {
    if (!event.mimeData()->hasFormat(object_mime))
        return event.ignore(); // The window handles missions and recordings.
    dragged_in_ = true;
    event.acceptProposedAction();
    showGhost(event.position());
}

void MapGestures::drop(QDropEvent& event) {
    if (!std::exchange(dragged_in_, false))
        return event.ignore();
    event.acceptProposedAction();
    const Vec2 at_m = transform_.toMap(event.position());
    showGhost({});
    emit placeRequested(at_m, false);
}

void MapGestures::cancel() {
    if (gesture_ == Gesture::DraggingArea)
        restoreArea();
    if (gesture_ == Gesture::PlacingRobot)
        content_.spawn_draft_in_map = draft_before_;
    if (gesture_ == Gesture::Measuring)
        content_.measured.reset();
    content_.objects.held.clear();
    forget();
}

bool MapGestures::escape() {
    if (inProgress())
        return cancel(), true;
    if (tool_ != MapTool::Pan)
        return setTool(MapTool::Pan), true;
    const auto before = std::exchange(content_.spawn_draft_in_map, {});
    if (before)
        emit draftPlaced(before, {});
    widget_.update();
    return before.has_value();
}

void MapGestures::forget() {
    gesture_ = Gesture::None;
    updateCursor();
    widget_.update();
}

void MapGestures::updateCursor() {
    Qt::CursorShape shape = tool_ == MapTool::Pan ? Qt::ArrowCursor : Qt::CrossCursor;
    if (gesture_ == Gesture::DraggingObject)
        shape = Qt::SizeAllCursor;
    else if (gesture_ == Gesture::Panning)
        shape = Qt::ClosedHandCursor;
    else if (content_.area.hot_grip)
        shape = content_.area.hot_grip->middle() ? Qt::SizeAllCursor : Qt::PointingHandCursor;
    else if (content_.hot_start_pose && tool_ == MapTool::Pan)
        shape = Qt::PointingHandCursor;
    widget_.setCursor(shape);
}

void MapGestures::hover(const QPointF& at_px) {
    content_.hot_start_pose = hits().startPoseAt(at_px);
    content_.area.hot_grip = tool_ == MapTool::Area ? hits().gripAt(at_px) : std::nullopt;
}

void MapGestures::beginDrag() {
    if (tool_ == MapTool::Area) {
        gesture_ = Gesture::DraggingArea;
        area_before_ = content_.area.area_in_map;
        held_grip_ = hits().gripAt(pressed_px_);
    } else if (!beginObjectDrag()) {
        gesture_ = Gesture::Panning;
    }
}

void MapGestures::dragArea(const QPointF& at_px) {
    const Vec2 to = transform_.toMap(at_px);
    const Rectangle area = held_grip_ ? dragged(*area_before_, {*held_grip_, pressed_m_, to}, content_.world_in_map)
                                      : spanned(pressed_m_, to, content_.world_in_map);
    if (area.empty())
        return;
    content_.area.area_in_map = area;
    emit areaEdited(area);
}

void MapGestures::finishAreaDrag(const QPointF& at_px) {
    const QString reason = held_grip_ ? QString() : refusal(pressed_m_, transform_.toMap(at_px), content_.world_in_map);
    if (!reason.isEmpty()) {
        restoreArea();
        emit areaRefused(reason);
    } else if (content_.area.area_in_map) {
        emit areaChanged(*content_.area.area_in_map);
    }
}

void MapGestures::restoreArea() {
    content_.area.area_in_map = area_before_;
    emit areaEdited(area_before_.value_or(Rectangle{}));
}

bool MapGestures::beginObjectDrag() {
    if (tool_ != MapTool::Pan || !hits().robotAt(pressed_px_).isEmpty())
        return false;
    const MapObject* const object = content_.object(hits().objectAt(pressed_px_));
    if (!object)
        return false;
    const QString name = object->name; // A receiver may replace the objects.
    gesture_ = Gesture::DraggingObject;
    content_.objects.held = name;
    held_from_m_ = object->body_in_map.position_m.head<2>();
    clickObject(name);
    return true;
}

void MapGestures::finishObjectDrag() {
    const QString name = std::exchange(content_.objects.held, {});
    MapObject* const object = content_.object(name);
    if (!object)
        return; // It has left the world in the meantime.
    // The object is drawn here until the server reports its place.
    object->body_in_map.position_m.head<2>() = content_.objects.held_to_m;
    emit objectMoved(name, content_.objects.held_to_m);
}

void MapGestures::setDraft(const std::optional<Pose>& draft_in_map) {
    content_.spawn_draft_in_map = draft_in_map;
    widget_.update();
}

void MapGestures::turnDraft(const QPointF& at_px) {
    constexpr double least_px = 8.0;
    const QPointF way = at_px - pressed_px_;
    if (content_.spawn_draft_in_map && std::hypot(way.x(), way.y()) >= least_px)
        content_.spawn_draft_in_map->yaw_rad = bearingOf(transform_.toMap(at_px) - pressed_m_);
}

void MapGestures::finishPlacing() {
    const auto before = std::exchange(draft_before_, {});
    const auto after = content_.spawn_draft_in_map;
    setTool(MapTool::Pan);
    if (after)
        emit draftPlaced(before, after);
}

void MapGestures::finishMeasuring() {
    if (content_.measured && content_.measured->length_m() > 0.0)
        emit lineMeasured(*content_.measured);
    else
        content_.measured.reset(); // A click draws no line.
}

void MapGestures::click(const QPointF& at_px, Qt::KeyboardModifiers modifiers) {
    if (clickWithTool(at_px, modifiers))
        return;
    if (const QString robot = hits().robotAt(at_px); !robot.isEmpty()) {
        content_.selected_robot = robot;
        emit robotClicked(robot);
    } else if (hits().draftAt(at_px)) {
        emit draftClicked();
    } else if (const auto pose = hits().startPoseAt(at_px)) {
        emit startPoseClicked(*pose);
    } else if (const QString object = hits().objectAt(at_px);
               object.isEmpty() && modifiers.testFlag(Qt::ControlModifier)) {
        emit writerAsked(transform_.toMap(at_px));
    } else if (!object.isEmpty() || !content_.objects.selected.isEmpty()) {
        clickObject(object);
    }
}

bool MapGestures::clickWithTool(const QPointF& at_px, Qt::KeyboardModifiers modifiers) {
    if (tool_ == MapTool::Place)
        emit placeRequested(transform_.toMap(at_px), modifiers & Qt::ShiftModifier);
    else if (tool_ == MapTool::Waypoint)
        emit waypointAdded(transform_.toMap(at_px));
    return tool_ == MapTool::Place || tool_ == MapTool::Waypoint;
}

void MapGestures::clickObject(const QString& name) {
    content_.objects.selected = name;
    emit objectClicked(name);
}

} // namespace usar::widgets
