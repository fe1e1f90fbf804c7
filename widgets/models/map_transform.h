// Where a point of the map is on the screen, and back: all view arithmetic of the map, no painting.
#pragma once

#include <QPointF>
#include <QRectF>
#include <QSizeF>

#include "core/base/geometry.h"

namespace usar::widgets {

/// Which map axis points up on the screen. XUp: x up, y left (as seen by a robot at yaw 0). YUp: x right, y up (as
/// exported pictures and GIS have it). Both are right-handed views from above.
enum class MapOrientation { XUp, YUp };

/// A value: center, scale, viewport. Screen points are device-independent pixels, y down. The scale is kept within
/// `minimum_scale`..`maximum_scale` pixels per metre.
struct MapTransform {
    static constexpr double minimum_scale = 0.02;
    static constexpr double maximum_scale = 400.0;

    MapOrientation orientation = MapOrientation::XUp;
    Vec2 center_m = Vec2::Zero();
    double pixels_per_m = 5.0;
    QSizeF viewport{640.0, 480.0};

    QPointF toScreen(const Vec2& point_in_map_m) const;
    Vec2 toMap(const QPointF& point_px) const;
    QRectF toScreen(const Rectangle& rectangle_in_map) const;
    /// What the viewport shows, in the map frame.
    Rectangle visible() const;
    /// Screen direction of a yaw: clockwise from "up", in radians, as a painter's rotation takes it.
    double screenRotation_rad(double yaw_rad) const;

    /// The ground under the cursor stays under the cursor.
    void zoomAt(const QPointF& cursor_px, double factor);
    /// Moves the ground by this many pixels.
    void pan(const QPointF& by_px);
    /// Shows all of `rectangle_in_map` with a margin; an empty rectangle changes nothing.
    void fit(const Rectangle& rectangle_in_map, double margin_px = 32.0);

    bool operator==(const MapTransform&) const = default;
};

/// 1, 2 or 5 times a power of ten, at most `maximum`; for grids and scale bars.
double roundStep(double maximum);

} // namespace usar::widgets
