#include "widgets/models/map/label_places.h"

#include <algorithm>

namespace usar::widgets {

namespace {

constexpr double farther_px = 16.0;

QRectF box(const LabelWish& wish, const QPointF& direction, double clear_px) {
    const QPointF half(wish.size_px.width() / 2.0, wish.size_px.height() / 2.0);
    const QPointF middle =
        wish.anchor_px + QPointF(direction.x() * (clear_px + half.x()), direction.y() * (clear_px + half.y()));
    return {middle - half, wish.size_px};
}

std::optional<QRectF> freeBox(const LabelWish& wish, const std::vector<QRectF>& taken_px) {
    const QPointF below(0.0, 1.0);
    const QPointF right(1.0, 0.0);
    for (const double clear_px : {wish.clear_px, wish.clear_px + farther_px})
        for (const QPointF& direction : {below, right, -right, -below}) {
            const QRectF there = box(wish, direction, clear_px);
            if (std::ranges::none_of(taken_px, [&](const QRectF& other) { return other.intersects(there); }))
                return there;
        }
    return wish.must_show ? std::optional(box(wish, below, wish.clear_px)) : std::nullopt;
}

} // namespace

std::vector<std::optional<QRectF>> placeLabels(const std::vector<LabelWish>& wishes, std::vector<QRectF> taken_px) {
    std::vector<std::optional<QRectF>> places;
    places.reserve(wishes.size());
    for (const LabelWish& wish : wishes) {
        places.push_back(freeBox(wish, taken_px));
        if (places.back())
            taken_px.push_back(*places.back());
    }
    return places;
}

} // namespace usar::widgets
