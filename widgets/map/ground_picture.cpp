#include "widgets/map/ground_picture.h"

#include <cmath>

#include "widgets/map/scenery_painter.h"
#include "widgets/style/sheet.h"

namespace usar::widgets {

namespace {

void paintBackgroundImage(QPainter& painter, const MapContent& content, const MapTransform& transform) {
    if (content.background.isNull())
        return;
    const Rectangle& at = content.background_in_map;
    painter.save();
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    if (transform.orientation == MapOrientation::XUp) {
        painter.translate(transform.toScreen(Vec2(at.min_m.x(), at.max_m.y())));
        painter.rotate(-90.0);
        const double s = transform.pixels_per_m;
        painter.drawImage(QRectF(0.0, 0.0, at.width_m() * s, at.height_m() * s), content.background);
    } else {
        painter.drawImage(transform.toScreen(at), content.background);
    }
    painter.restore();
}

/// Paints ground and picture at the layer's opacity, but frame and name opaque: they stay readable, however faint the
/// picture is.
void paintWorld(QPainter& painter, const MapContent& content, const MapTransform& transform) {
    if (!content.world_in_map)
        return;
    const QRectF world = transform.toScreen(*content.world_in_map);
    painter.setOpacity(content.layer(MapLayer::World).opacity);
    painter.fillRect(world, tokens().ground);
    paintBackgroundImage(painter, content, transform);
    painter.setOpacity(1.0);
    painter.setPen(QPen(tokens().text_muted, 1.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(world);
    painter.setFont(themeFont(FontRole::Small));
    painter.drawText(world.topLeft() + QPointF(0.0, -gap::small), content.world_name);
}

void paintGrid(QPainter& painter, const MapContent& content, const MapTransform& transform) {
    const double step_m = roundStep(96.0 / transform.pixels_per_m);
    Rectangle seen = transform.visible();
    if (const auto& world = content.world_in_map)
        seen = {seen.min_m.cwiseMax(world->min_m), seen.max_m.cwiseMin(world->max_m)};
    if (seen.empty())
        return;
    painter.setOpacity(content.layer(MapLayer::Grid).opacity);
    const QColor color = faded(tokens().line, 0.55);
    const auto paintLine = [&](const Vec2& from_m, const Vec2& to_m) {
        const QRectF line(transform.toScreen(from_m), transform.toScreen(to_m));
        fillInStrips(painter, line.normalized().adjusted(-0.5, -0.5, 0.5, 0.5), color);
    };
    for (double x = std::ceil(seen.min_m.x() / step_m) * step_m; x <= seen.max_m.x(); x += step_m)
        paintLine({x, seen.min_m.y()}, {x, seen.max_m.y()});
    for (double y = std::ceil(seen.min_m.y() / step_m) * step_m; y <= seen.max_m.y(); y += step_m)
        paintLine({seen.min_m.x(), y}, {seen.max_m.x(), y});
}

bool seen(const LayerState& layer) {
    return layer.visible && layer.opacity > 0.0;
}

} // namespace

void GroundPicture::paint(QPainter& painter, const MapContent& content, const MapTransform& transform) {
    const Shown shown{transform,
                      content.world_in_map,
                      content.world_name,
                      content.background.cacheKey(),
                      content.background_in_map,
                      content.layer(MapLayer::World),
                      content.layer(MapLayer::Grid),
                      content.scenery,
                      content.layer(MapLayer::Objects),
                      currentTheme(),
                      painter.device()->devicePixelRatioF()};
    if (shown_ != shown) {
        shown_ = shown;
        ++times_made_;
        const QSize size = (transform.viewport * shown.pixel_ratio).toSize();
        if (picture_.size() != size)
            picture_ = QImage(size, QImage::Format_RGB32);
        picture_.setDevicePixelRatio(shown.pixel_ratio);
        picture_.fill(tokens().background);
        QPainter ground(&picture_);
        if (seen(shown.world))
            paintWorld(ground, content, transform);
        if (seen(shown.grid))
            paintGrid(ground, content, transform);
        if (seen(shown.objects) && content.scenery) {
            ground.setOpacity(shown.objects.opacity);
            paintScenery(ground, *content.scenery, transform);
        }
    }
    painter.drawImage(0, 0, picture_);
}

} // namespace usar::widgets
