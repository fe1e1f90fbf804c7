#include "widgets/map/scenery_painter.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <QImage>

#include "widgets/style/theme.h"

namespace usar::widgets {

namespace {

constexpr double least_tree_px = 1.2;  ///< radius; smaller trees are points
constexpr double most_stamp_px = 24.0; ///< radius; of larger trees only few are in sight
constexpr double steps_per_px = 2.0;   ///< sizes of stamps

const QColor& crownColor() {
    static const QColor dark(0x5f9a6b);
    static const QColor light(0x4c8759);
    return currentTheme() == Theme::Dark ? dark : light;
}

/// Pictures of trees, made when first needed.
class Stamps {
public:
    explicit Stamps(double pixel_ratio) : pixel_ratio_(pixel_ratio) {}

    const QImage& of(double crown_px, double trunk_px) {
        const std::pair key(int(std::lround(crown_px * steps_per_px)), int(std::lround(trunk_px * steps_per_px)));
        auto found = stamps_.find(key);
        if (found == stamps_.end())
            found = stamps_.emplace(key, make(key.first / steps_per_px, key.second / steps_per_px)).first;
        return found->second;
    }

private:
    QImage make(double crown_px, double trunk_px) const {
        const int half_px = int(std::ceil(std::max(crown_px, trunk_px))) + 1;
        QImage stamp(QSize(2 * half_px, 2 * half_px) * pixel_ratio_, QImage::Format_ARGB32_Premultiplied);
        stamp.setDevicePixelRatio(pixel_ratio_);
        stamp.fill(Qt::transparent);
        QPainter painter(&stamp);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.translate(half_px, half_px);
        paintTree(painter, crown_px, trunk_px);
        return stamp;
    }

    double pixel_ratio_;
    std::map<std::pair<int, int>, QImage> stamps_;
};

void paintBuildings(QPainter& painter, const Scenery& scenery, const MapTransform& transform, const QRectF& sight) {
    painter.setPen(QPen(tokens().text_muted, 1.0));
    painter.setBrush(faded(tokens().text_muted, 0.25));
    for (const Outline& building : scenery.buildings) {
        QPolygonF outline;
        for (const Vec2& corner_m : building)
            outline << transform.toScreen(corner_m);
        if (outline.boundingRect().intersects(sight))
            painter.drawPolygon(outline);
    }
}

} // namespace

void paintTree(QPainter& painter, double crown_px, double trunk_px) {
    painter.setPen(QPen(faded(crownColor(), 0.6), std::min(1.0, crown_px / 4.0)));
    painter.setBrush(faded(crownColor(), 0.3));
    painter.drawEllipse(QPointF(), crown_px, crown_px);
    painter.setPen(Qt::NoPen);
    painter.setBrush(tokens().text_muted);
    if (trunk_px > 0.0)
        painter.drawEllipse(QPointF(), trunk_px, trunk_px);
}

void paintScenery(QPainter& painter, const Scenery& scenery, const MapTransform& transform) {
    const QRectF sight(QPointF(), transform.viewport);
    painter.setRenderHint(QPainter::Antialiasing);
    paintBuildings(painter, scenery, transform, sight);
    Stamps stamps(painter.device()->devicePixelRatioF());
    QVector<QPointF> points;
    for (const SceneryTree& tree : scenery.trees) {
        const QPointF at = transform.toScreen(tree.center_m);
        const double crown_px = tree.crown_radius_m * transform.pixels_per_m;
        // A trunk that is told from its crown only when close is not worth a dot.
        const double trunk_px = crown_px > 6.0 || tree.crown_radius_m <= 0.0
                                    ? std::max(tree.trunk_radius_m * transform.pixels_per_m, 0.75)
                                    : 0.0;
        const double reach_px = std::max(crown_px, trunk_px);
        if (!sight.adjusted(-reach_px, -reach_px, reach_px, reach_px).contains(at))
            continue;
        if (reach_px < least_tree_px) {
            points << at;
        } else if (reach_px <= most_stamp_px) {
            const QImage& stamp = stamps.of(crown_px, tree.trunk_radius_m > 0.0 ? trunk_px : 0.0);
            const QSizeF size = stamp.deviceIndependentSize();
            painter.drawImage((at - QPointF(size.width(), size.height()) / 2.0).toPoint(), stamp);
        } else {
            painter.save();
            painter.translate(at);
            paintTree(painter, crown_px, tree.trunk_radius_m > 0.0 ? trunk_px : 0.0);
            painter.restore();
        }
    }
    painter.setPen(QPen(faded(crownColor(), 0.8), 2.0));
    painter.drawPoints(points.data(), int(points.size()));
    painter.setRenderHint(QPainter::Antialiasing, false);
}

} // namespace usar::widgets
