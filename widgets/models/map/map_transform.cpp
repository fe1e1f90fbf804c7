#include "widgets/models/map/map_transform.h"

#include <algorithm>
#include <cmath>

namespace usar::widgets {

QPointF MapTransform::toScreen(const Vec2& point_in_map_m) const {
    const Vec2 d = (point_in_map_m - center_m) * pixels_per_m;
    const QPointF middle(viewport.width() / 2.0, viewport.height() / 2.0);
    return orientation == MapOrientation::XUp ? middle + QPointF(-d.y(), -d.x()) : middle + QPointF(d.x(), -d.y());
}

Vec2 MapTransform::toMap(const QPointF& point_px) const {
    const QPointF d = (point_px - QPointF(viewport.width() / 2.0, viewport.height() / 2.0)) / pixels_per_m;
    return center_m + (orientation == MapOrientation::XUp ? Vec2(-d.y(), -d.x()) : Vec2(d.x(), -d.y()));
}

QRectF MapTransform::toScreen(const Rectangle& rectangle_in_map) const {
    return QRectF(toScreen(rectangle_in_map.min_m), toScreen(rectangle_in_map.max_m)).normalized();
}

Rectangle MapTransform::visible() const {
    const Vec2 a = toMap(QPointF(0.0, 0.0));
    const Vec2 b = toMap(QPointF(viewport.width(), viewport.height()));
    return {a.cwiseMin(b), a.cwiseMax(b)};
}

double MapTransform::screenRotation_rad(double yaw_rad) const {
    return orientation == MapOrientation::XUp ? -yaw_rad : pi / 2.0 - yaw_rad;
}

void MapTransform::zoomAt(const QPointF& cursor_px, double factor) {
    const Vec2 before = toMap(cursor_px);
    pixels_per_m = std::clamp(pixels_per_m * factor, minimum_scale, maximum_scale);
    center_m += before - toMap(cursor_px);
}

void MapTransform::fit(const Rectangle& rectangle_in_map, double margin_px) {
    if (rectangle_in_map.empty())
        return;
    const bool x_up = orientation == MapOrientation::XUp;
    const double across_m = x_up ? rectangle_in_map.height_m() : rectangle_in_map.width_m();
    const double up_m = x_up ? rectangle_in_map.width_m() : rectangle_in_map.height_m();
    const double scale = std::min(std::max(1.0, viewport.width() - 2.0 * margin_px) / across_m,
                                  std::max(1.0, viewport.height() - 2.0 * margin_px) / up_m);
    pixels_per_m = std::clamp(scale, minimum_scale, maximum_scale);
    center_m = rectangle_in_map.center_m();
}

namespace {

/// What is left of the viewport beside or else above and below each of the boxes: bit i of `choice` decides for box i.
QRectF roomFor(const QSizeF& viewport, const std::vector<QRectF>& boxes, unsigned choice, double margin_px) {
    constexpr double gap_px = 24.0; // Half of a robot's symbol and a little more.
    const QPointF middle(viewport.width() / 2.0, viewport.height() / 2.0);
    QRectF room(margin_px, margin_px, viewport.width() - 2.0 * margin_px, viewport.height() - 2.0 * margin_px);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        const QRectF& box = boxes[i];
        const bool beside = (choice >> i & 1u) != 0;
        if (beside && box.center().x() < middle.x())
            room.setLeft(std::max(room.left(), box.right() + gap_px));
        else if (beside)
            room.setRight(std::min(room.right(), box.left() - gap_px));
        else if (box.center().y() < middle.y())
            room.setTop(std::max(room.top(), box.bottom() + gap_px));
        else
            room.setBottom(std::min(room.bottom(), box.top() - gap_px));
    }
    return room;
}

} // namespace

void MapTransform::fitClearOf(const Rectangle& rectangle_in_map, const std::vector<QRectF>& corner_boxes_px,
                              double margin_px) {
    constexpr double least_part = 0.4;
    fit(rectangle_in_map, margin_px);
    MapTransform best = *this;
    best.pixels_per_m = least_part * pixels_per_m;
    bool found = false;
    for (unsigned choice = 0; choice < 1u << corner_boxes_px.size(); ++choice) {
        const QRectF room = roomFor(viewport, corner_boxes_px, choice, margin_px);
        if (room.isEmpty())
            continue;
        MapTransform fitted = *this;
        fitted.viewport = room.size();
        fitted.fit(rectangle_in_map, 0.0);
        if (fitted.pixels_per_m <= best.pixels_per_m)
            continue;
        fitted.viewport = viewport;
        fitted.pan(room.center() - QPointF(viewport.width() / 2.0, viewport.height() / 2.0));
        best = fitted;
        found = true;
    }
    if (found)
        *this = best;
}

double roundStep(double maximum) {
    if (!(maximum > 0.0) || !std::isfinite(maximum))
        return 1.0;
    const double decade = std::pow(10.0, std::floor(std::log10(maximum)));
    for (const double step : {5.0, 2.0})
        if (step * decade <= maximum)
            return step * decade;
    return decade;
}

} // namespace usar::widgets
