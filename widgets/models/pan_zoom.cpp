#include "widgets/models/pan_zoom.h"

#include <algorithm>
#include <cmath>

namespace usar::widgets {

namespace {

QPointF halfOf(const QSizeF& viewport, double scale) {
    return QPointF(viewport.width(), viewport.height()) / (2.0 * scale);
}

} // namespace

double zoom_step::ofWheel(int angle_delta) {
    return std::pow(1.2, angle_delta / 120.0);
}

void PanZoom::zoomAt(const QPointF& on_screen, double factor) {
    const QPointF held = toDrawing(on_screen);
    scale = std::clamp(scale * factor, minimum_scale, maximum_scale);
    corner = held - on_screen / scale;
}

void PanZoom::fit(const QRectF& bounds, const QSizeF& viewport) {
    if (bounds.isEmpty())
        return;
    const double across = (viewport.width() - 2.0 * margin_px) / bounds.width();
    const double down = (viewport.height() - 2.0 * margin_px) / bounds.height();
    scale = std::clamp(std::min(across, down), minimum_scale, 1.0);
    corner = bounds.center() - halfOf(viewport, scale);
}

void PanZoom::showBeginning(const QRectF& bounds, const QSizeF& viewport) {
    fit(bounds, viewport);
    if (scale >= readable_scale || bounds.isEmpty())
        return;
    const double across = (viewport.width() - 2.0 * margin_px) / bounds.width();
    scale = std::clamp(across, readable_scale, 1.0);
    corner = bounds.topLeft() - QPointF(margin_px, margin_px) / scale;
}

void PanZoom::keepInReach(const QRectF& bounds, const QSizeF& viewport) {
    const QSizeF room = viewport / scale;
    const QPointF rest(std::min(room.width(), bounds.width()) / 4.0, std::min(room.height(), bounds.height()) / 4.0);
    corner.rx() = std::clamp(corner.x(), bounds.left() - room.width() + rest.x(), bounds.right() - rest.x());
    corner.ry() = std::clamp(corner.y(), bounds.top() - room.height() + rest.y(), bounds.bottom() - rest.y());
}

bool PanZoom::bringIntoView(const QRectF& box, const QSizeF& viewport) {
    const QRectF wanted = box.adjusted(-margin_px, -margin_px, margin_px, margin_px);
    const QSizeF room = viewport / scale;
    const auto moved = [](double from, double length, double first, double last) {
        return std::min(std::max(from, last - length), first);
    };
    const QPointF before = corner;
    corner = {moved(corner.x(), room.width(), wanted.left(), wanted.right()),
              moved(corner.y(), room.height(), wanted.top(), wanted.bottom())};
    return corner != before;
}

} // namespace usar::widgets
