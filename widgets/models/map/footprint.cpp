#include "widgets/models/map/footprint.h"

#include <algorithm>

#include <QPolygonF>
#include <QTransform>

namespace usar::widgets {

FootprintPtr footprintOf(const std::vector<Outline>& outlines_in_base) {
    constexpr double fine = 1000.0; // QPainterPath takes points that are close in its own units for one.
    auto made = std::make_shared<Footprint>();
    QPainterPath all;
    for (const Outline& outline : outlines_in_base) {
        QPolygonF polygon;
        for (const Vec2& point_m : outline) {
            polygon << fine * QPointF(-point_m.y(), -point_m.x());
            made->reach_m = std::max(made->reach_m, point_m.norm());
        }
        QPainterPath part;
        part.addPolygon(polygon);
        part.closeSubpath();
        all = all.united(part);
    }
    made->shape = QTransform::fromScale(1.0 / fine, 1.0 / fine).map(all);
    const QRectF bounds = made->shape.boundingRect();
    made->length_m = std::max(bounds.width(), bounds.height());
    return made->length_m > 0.0 ? made : nullptr;
}

FootprintPtr Footprints::of(const QString& class_name, const std::map<QString, std::vector<Outline>>& known,
                            const std::optional<Vec3>& told_dimensions_m) {
    const auto file = known.find(class_name.section('.', -1));
    QString key = class_name;
    std::vector<Outline> from;
    if (file != known.end()) {
        from = file->second;
    } else if (told_dimensions_m && told_dimensions_m->allFinite()) {
        from = {outlineOfBox({}, *told_dimensions_m)};
        key += QStringLiteral(" %1 x %2").arg(told_dimensions_m->x()).arg(told_dimensions_m->y());
    } else {
        return nullptr;
    }
    Made& made = made_[key];
    if (made.from != from)
        made = {from, footprintOf(from)};
    return made.footprint;
}

} // namespace usar::widgets
