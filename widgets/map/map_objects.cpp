// Objects of the world on the map: painting, and the mouse and key handling for them.
#include <algorithm>
#include <cmath>

#include <QDragEnterEvent>
#include <QMimeData>

#include "widgets/map/map_painter.h"
#include "widgets/map/map_view.h"
#include "widgets/models/figures.h"

namespace usar::widgets {

namespace {

constexpr double least_px = 5.0; ///< smallest half size of an object on the screen

QPolygonF outlineOnScreen(const MapObject& object, const MapTransform& transform) {
    QPolygonF outline;
    for (const Vec2& corner_m : outlineOf(object))
        outline << transform.toScreen(corner_m);
    const QPointF center = transform.toScreen(object.body_in_map.position_m.head<2>());
    const QRectF bounds = outline.boundingRect();
    const double half = std::max(bounds.width(), bounds.height()) / 2.0;
    if (half > 0.0 && half < least_px)
        for (QPointF& corner : outline)
            corner = center + (corner - center) * least_px / half;
    return outline;
}

MapObject movedTo(MapObject object, const Vec2& center_m) {
    object.body_in_map.position_m.head<2>() = center_m;
    return object;
}

} // namespace

void paintObjectSymbol(QPainter& painter, const QPolygonF& outline, bool selected) {
    const Tokens& t = tokens();
    QColor fill = selected ? t.accent : t.text_muted;
    fill.setAlphaF(0.45f);
    painter.setPen(QPen(t.background, 3.0, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin));
    painter.setBrush(Qt::NoBrush);
    painter.drawPolygon(outline);
    painter.setPen(
        QPen(selected ? t.accent : t.text, selected ? 2.0 : 1.25, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin));
    painter.setBrush(fill);
    painter.drawPolygon(outline);
}

void MapPainter::paintObjects() {
    painter_.setRenderHint(QPainter::Antialiasing);
    const ObjectsOnMap& things = content_.objects;
    const MapObject* selected = nullptr;
    for (const MapObject& object : things.objects)
        if (object.name == things.selected)
            selected = &object;
        else
            paintObject(object, false);
    if (selected) { // Above its neighbors.
        paintWaypoints(*selected);
        paintObject(*selected, true);
    }
    painter_.setOpacity(0.6);
    for (const MapObject& object : things.objects)
        if (object.name == things.held)
            paintObject(movedTo(object, things.held_to_m), true);
    if (things.ghost)
        paintObject(*things.ghost, true);
}

void MapPainter::paintObject(const MapObject& object, bool selected) {
    const QPolygonF outline = outlineOnScreen(object, transform_);
    const QRectF bounds = outline.boundingRect();
    if (!bounds.adjusted(-80.0, -8.0, 80.0, 24.0).intersects(QRectF(QPointF(), transform_.viewport)))
        return;
    paintObjectSymbol(painter_, outline, selected);
    const QPointF center = bounds.center();
    if (object.carries) { // Arrow in the direction of the belt.
        const Vec3 along = object.body_in_map * Vec3(0.35 * object.size_m.x(), 0.0, 0.0);
        const QPointF tip = transform_.toScreen(Vec2(along.head<2>()));
        painter_.drawLine(2.0 * center - tip, tip);
        const double turn = std::atan2(tip.y() - center.y(), tip.x() - center.x());
        for (const double side : {2.6, -2.6})
            painter_.drawLine(tip, tip + 5.0 * QPointF(std::cos(turn + side), std::sin(turn + side)));
    }
    if (!selected)
        return;
    const QSizeF size(QFontMetricsF(themeFont(FontRole::Small, QFont::DemiBold)).horizontalAdvance(object.name) + 10.0,
                      18.0);
    paintLabel(QRectF(QPointF(center.x() - size.width() / 2.0, bounds.top() - gap::tiny - size.height()), size),
               object.name, true);
}

void MapPainter::paintWaypoints(const MapObject& object) {
    QPointF from = transform_.toScreen(Vec2(object.body_in_map.position_m.head<2>()));
    QPen dashed(tokens_.accent, 1.5);
    dashed.setDashPattern({3.0, 3.0});
    painter_.setFont(themeFont(FontRole::Small, QFont::DemiBold));
    int number = 0;
    for (const Vec2& point_m : object.waypoints_in_map_m) {
        const QPointF at = transform_.toScreen(point_m);
        painter_.setPen(dashed);
        painter_.drawLine(from, at);
        painter_.setPen(QPen(tokens_.accent, 1.5));
        painter_.setBrush(tokens_.background);
        painter_.drawEllipse(at, 8.0, 8.0);
        painter_.setPen(tokens_.text);
        painter_.drawText(QRectF(at - QPointF(8.0, 8.0), QSizeF(16.0, 16.0)), Qt::AlignCenter,
                          QString::number(++number));
        from = at;
    }
}

void MapView::setObjects(const std::vector<MapObject>& objects) {
    content_.objects.objects = objects;
    const auto is = [&](const QString& name) {
        return std::ranges::find(objects, name, &MapObject::name) != objects.end();
    };
    if (!is(content_.objects.selected))
        content_.objects.selected.clear();
    if (!is(content_.objects.held))
        content_.objects.held.clear();
    update();
}

void MapView::selectObject(const QString& name) {
    content_.objects.selected = name;
    update();
}

void MapView::setGhost(const std::optional<MapObject>& ghost) {
    ghost_ = ghost;
    showGhost(cursor_px_);
}

void MapView::showGhost(const std::optional<QPointF>& at_px) {
    content_.objects.ghost.reset();
    if (ghost_ && at_px && (tool_ == MapTool::Place || dragged_in_))
        content_.objects.ghost = movedTo(*ghost_, transform_.toMap(*at_px));
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

/// Returns the topmost object at that place, with a tolerance of a few pixels for small ones.
QString MapView::objectAt(const QPointF& point_px) const {
    if (!content_.layer(MapLayer::Objects).visible)
        return {};
    const auto hit = [&](const MapObject& object) {
        const QPolygonF outline = outlineOnScreen(object, transform_);
        return outline.containsPoint(point_px, Qt::OddEvenFill) ||
               outline.boundingRect().adjusted(-3.0, -3.0, 3.0, 3.0).contains(point_px);
    };
    const auto& objects = content_.objects.objects;
    const auto found = std::find_if(objects.rbegin(), objects.rend(), hit);
    return found == objects.rend() ? QString() : found->name;
}

bool MapView::beginObjectDrag(const QPointF& point_px) {
    const QString name = tool_ == MapTool::Pan && robotAt(point_px).isEmpty() ? objectAt(point_px) : QString();
    const auto object = std::ranges::find(content_.objects.objects, name, &MapObject::name);
    if (object == content_.objects.objects.end())
        return false;
    gesture_ = Gesture::DraggingObject;
    content_.objects.held = name;
    held_from_m_ = object->body_in_map.position_m.head<2>();
    selectObject(name);
    emit objectClicked(name);
    return true;
}

void MapView::dragObject(const QPointF& point_px) {
    content_.objects.held_to_m = held_from_m_ + transform_.toMap(point_px) - pressed_m_;
    update();
}

void MapView::finishObjectDrag() {
    const QString name = std::exchange(content_.objects.held, {});
    const auto object = std::ranges::find(content_.objects.objects, name, &MapObject::name);
    if (object == content_.objects.objects.end())
        return; // It has left the world in the meantime.
    // The object is drawn here until the server reports its place.
    object->body_in_map.position_m.head<2>() = content_.objects.held_to_m;
    emit objectMoved(name, content_.objects.held_to_m);
}

/// Returns true if the click was meant for a new object or a way point.
bool MapView::clickWithTool(const QPointF& point_px, Qt::KeyboardModifiers modifiers) {
    if (tool_ == MapTool::Place)
        emit placeRequested(transform_.toMap(point_px), modifiers & Qt::ShiftModifier);
    else if (tool_ == MapTool::Waypoint)
        emit waypointAdded(transform_.toMap(point_px));
    return tool_ == MapTool::Place || tool_ == MapTool::Waypoint;
}

void MapView::clickObject(const QPointF& point_px) {
    const QString name = objectAt(point_px);
    if (name.isEmpty() && content_.objects.selected.isEmpty())
        return;
    selectObject(name);
    emit objectClicked(name);
}

QString MapView::objectToolTip(const QPointF& point_px) const {
    const auto object = std::ranges::find(content_.objects.objects, objectAt(point_px), &MapObject::name);
    if (object == content_.objects.objects.end())
        return {};
    return tr("%1 %2, %3 × %4 × %5 m. Drag moves it, Delete removes it.")
        .arg(object->kind, object->name, figure(object->size_m.x(), 2), figure(object->size_m.y(), 2),
             figure(object->size_m.z(), 2));
}

void MapView::dragEnterEvent(QDragEnterEvent* event) {
    if (!event->mimeData()->hasFormat(object_mime))
        return event->ignore(); // The window handles missions and recordings.
    dragged_in_ = true;
    event->acceptProposedAction();
    showGhost(event->position());
}

void MapView::dragMoveEvent(QDragMoveEvent* event) {
    showGhost(event->position());
    event->setAccepted(dragged_in_);
}

void MapView::dragLeaveEvent(QDragLeaveEvent*) {
    dragged_in_ = false;
    showGhost({});
}

void MapView::dropEvent(QDropEvent* event) {
    if (!std::exchange(dragged_in_, false))
        return event->ignore();
    event->acceptProposedAction();
    const Vec2 at_m = transform_.toMap(event->position());
    showGhost({});
    emit placeRequested(at_m, false);
}

} // namespace usar::widgets
