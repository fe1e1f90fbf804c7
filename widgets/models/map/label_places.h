// Arithmetic that places names beside their symbols so that none covers another.
#pragma once

#include <optional>
#include <vector>

#include <QPointF>
#include <QRectF>

namespace usar::widgets {

/// A label that needs a place. All lengths are in pixels of the screen.
struct LabelWish {
    QPointF anchor_px;      ///< middle of its symbol
    double clear_px = 0.0;  ///< distance from there to the nearest edge of the label
    QSizeF size_px;         ///< size of the label's box
    bool must_show = false; ///< without free room it is placed below, over whatever is there
};

/// Returns a box for each wish, or nullopt if there is no room. Earlier wishes take precedence. Tries below, right,
/// left and above, first near and then a little farther away, because a symbol may lie under a larger one. `taken_px`
/// are boxes that no label may cover.
std::vector<std::optional<QRectF>> placeLabels(const std::vector<LabelWish>& wishes, std::vector<QRectF> taken_px);

} // namespace usar::widgets
