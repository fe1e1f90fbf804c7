// Draws the path of a robot as the correction of its map has it, beside the trail, which is where it believed to be.
#pragma once

#include <memory>
#include <vector>

#include <QPainter>

#include "widgets/models/map/map_transform.h"

namespace usar::widgets {

/// Points in meters of the map frame that nobody changes any more; null: none.
using SharedPath = std::shared_ptr<const std::vector<Vec2>>;

/// Paints a dashed line on a strip of the background's color, so that it can be told from the solid trails on every
/// ground and without colors. The dashes lie the same whatever part of the view `sight_px` is. GUI thread.
void paintCorrectedPath(QPainter& painter, const std::vector<Vec2>& points_m, const MapTransform& transform,
                        const QRectF& sight_px);
/// Paints a short piece of it, two dashes, for legends.
void paintCorrectedSwatch(QPainter& painter, const QPointF& center_px);

} // namespace usar::widgets
