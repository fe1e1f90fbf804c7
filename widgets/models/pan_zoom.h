// Scale and position of a drawing in a view; all arithmetic of panning and zooming it, without painting.
#pragma once

#include <QPointF>
#include <QRectF>
#include <QSizeF>

namespace usar::widgets {

/// Factors of one step of zooming, the same in every view.
namespace zoom_step {
inline constexpr double closer = 1.25; ///< by key or command
inline constexpr double farther = 0.8;
/// Returns the factor for a turn of the mouse wheel, given as the y of QWheelEvent::angleDelta: 1.2 for each notch of
/// 120.
double ofWheel(int angle_delta);
} // namespace zoom_step

/// A plain value. Places in the drawing are in pixels at a scale of 1, places on the screen in device-independent
/// pixels; y goes down in both. The viewport is the size of the view; empty bounds are those of an empty drawing.
struct PanZoom {
    static constexpr double minimum_scale = 0.01;
    static constexpr double maximum_scale = 4.0;
    /// Smallest scale at which texts can be read.
    static constexpr double readable_scale = 0.8;
    /// Margin around the shown part.
    static constexpr double margin_px = 16.0;

    /// Screen pixels for each pixel of the drawing.
    double scale = 1.0;
    /// Place of the drawing that is in the top left corner of the view.
    QPointF corner;

    QPointF toScreen(const QPointF& in_drawing) const { return (in_drawing - corner) * scale; }
    QPointF toDrawing(const QPointF& on_screen) const { return on_screen / scale + corner; }

    /// Multiplies the scale by `factor`, within the limits; the place under the cursor stays there.
    void zoomAt(const QPointF& on_screen, double factor);
    /// Moves the drawing by this many pixels of the screen.
    void panBy(const QPointF& by_px) { corner -= by_px / scale; }
    /// Shows all of the drawing with a margin around it, but never enlarged. Empty bounds change nothing.
    void fit(const QRectF& bounds, const QSizeF& viewport);
    /// Like fit(), but if that is too small to be read, shows the top left part at a readable scale.
    void showBeginning(const QRectF& bounds, const QSizeF& viewport);
    /// Keeps part of the drawing in view, so that the user does not get lost.
    void keepInReach(const QRectF& bounds, const QSizeF& viewport);
    /// Scrolls no further than necessary to show the box with a margin; shows the beginning of a box that is larger
    /// than the view. Returns true if the drawing has moved.
    bool bringIntoView(const QRectF& box, const QSizeF& viewport);

    bool operator==(const PanZoom&) const = default;
};

} // namespace usar::widgets
