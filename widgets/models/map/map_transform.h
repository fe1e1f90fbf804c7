// Transforms points between map and screen; all arithmetic of the map view, without painting.
#pragma once

#include <vector>

#include <QPointF>
#include <QRectF>
#include <QSizeF>

#include "core/base/geometry.h"

namespace usar::widgets {

/// Which map axis points up on the screen. XUp: x up, y to the left (as a robot at yaw 0 sees it). YUp: x to the right,
/// y up (as in exported pictures and GIS). Both are right-handed views from above.
enum class MapOrientation { XUp, YUp };

/// Center, scale and viewport, as a value. Screen points are device-independent pixels, y down. The scale is kept
/// between `minimum_scale` and `maximum_scale` pixels per meter.
struct MapTransform {
    static constexpr double minimum_scale = 0.02;
    static constexpr double maximum_scale = 400.0;

    MapOrientation orientation = MapOrientation::XUp;
    Vec2 center_m = Vec2::Zero();
    double pixels_per_m = 5.0;
    QSizeF viewport{640.0, 480.0};

    /// Converts map points in meters to screen points in pixels and back.
    QPointF toScreen(const Vec2& point_in_map_m) const;
    Vec2 toMap(const QPointF& point_px) const;
    /// Bounding rectangle on the screen.
    QRectF toScreen(const Rectangle& rectangle_in_map) const;
    /// The visible part of the map, in meters of the map frame.
    Rectangle visible() const;
    /// Screen direction of a yaw: clockwise from "up", in radians; a painter's rotation in degrees has the same sense.
    double screenRotation_rad(double yaw_rad) const;

    /// Multiplies the scale by `factor`; the ground under the cursor stays there.
    void zoomAt(const QPointF& cursor_px, double factor);
    /// Moves the ground by this many pixels.
    void pan(const QPointF& by_px) { center_m += toMap(QPointF(0.0, 0.0)) - toMap(by_px); }
    /// Shows all of `rectangle_in_map` with a margin; an empty rectangle changes nothing.
    void fit(const Rectangle& rectangle_in_map, double margin_px = 32.0);

    /// As large as possible so that `rectangle_in_map` lies under none of these boxes at the corners of the viewport
    /// and keeps `margin_px` to its edges. Where this would leave little of the scale, the boxes are ignored.
    void fitClearOf(const Rectangle& rectangle_in_map, const std::vector<QRectF>& corner_boxes_px, double margin_px);

    bool operator==(const MapTransform&) const = default;
};

/// Largest value of the form 1, 2 or 5 times a power of ten that is at most `maximum`; for grids and scale bars.
double roundStep(double maximum);

} // namespace usar::widgets
