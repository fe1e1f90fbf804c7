// What lies on the glass of the map and does not move with it: scale bar, axes, legends, probe, focus ring.
#pragma once

#include <QPainter>

#include "widgets/height_layer.h"
#include "widgets/map_content.h"

namespace usar::widgets {

/// What the view knows and neither content nor transform can say.
struct MapOverlay {
    QString probe;     ///< "x 31.2  y −8.0  z 4.31 m  hits 7"; empty while the cursor is elsewhere
    QString following; ///< name of the robot that the view follows
    bool focused = false;
    bool legend = true;
};

/// What the axes dim in their corner; names keep out of it.
QRectF axesGlass_px(const MapTransform& transform);

/// Over all layers, once a frame; antialiasing is on afterwards. GUI thread.
void paintOverlay(QPainter& painter, const MapOverlay& overlay, const MapContent& content, const HeightLayer& heights,
                  const MapTransform& transform);

} // namespace usar::widgets
