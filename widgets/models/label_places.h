// Where names stand beside their symbols, so that none covers another. Arithmetic only.
#pragma once

#include <optional>
#include <vector>

#include <QPointF>
#include <QRectF>

namespace usar::widgets {

/// A name that wants a place. All lengths are pixels of the screen.
struct LabelWish {
    QPointF anchor_px;      ///< middle of its symbol
    double clear_px = 0.0;  ///< from there to the nearest edge of the name
    QSizeF size_px;         ///< of the name's box
    bool must_show = false; ///< where there is no room it goes below, over what is there
};

/// A box for each wish, or nothing where there is no room. Earlier wishes win. Tries below, right, left and above, near
/// and then a little farther, for a symbol may lie under a larger one. `taken_px` are boxes that no name may cover.
std::vector<std::optional<QRectF>> placeLabels(const std::vector<LabelWish>& wishes, std::vector<QRectF> taken_px);

} // namespace usar::widgets
