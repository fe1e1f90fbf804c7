// The drawing of a surface's tiles in perspective.
#pragma once

#include "core/mapping/relief/relief_picture.h"
#include "core/mapping/relief/relief_surface.h"

namespace usar::mapping {

/// Draws those tiles that are seen in the band, nearest first, each in the level of detail that ReliefScene::square_px
/// describes. Where two levels meet, the finer tile's border takes the corners of the coarser one, so that no gap
/// shows.
void drawSurface(const ReliefSurface& surface, const ReliefProjection& projection, double square_px, PictureBand band,
                 ReliefPen& pen);

} // namespace usar::mapping
