// Painting functions of the framed sheet that all painted instruments share.
#pragma once

#include <optional>
#include <vector>

#include <QPainter>
#include <QPointF>
#include <QString>
#include <QWidget>

namespace usar::widgets {

/// Paints frame and background over the whole widget; leaves antialiasing on.
void paintSheet(QPainter& painter, const QWidget& widget);
/// The same with a sentence that says what will appear here.
void paintEmptySheet(QPainter& painter, const QWidget& widget, const QString& sentence);
/// Paints the name on the left and the newest figure on the right. If stale, the figure is gray and the name says so.
void paintSheetHead(QPainter& painter, const QWidget& widget, const QString& name, const QString& value, bool stale);
/// Paints the ground in a cross-section: connects neighboring points and fills down to `bottom_px`. An absent point
/// interrupts the line, because nothing is known there. All coordinates are pixels.
void paintGround(QPainter& painter, const std::vector<std::optional<QPointF>>& line, double bottom_px, bool stale);
/// Paints a small note in the drawing on a background of its own, because lines may pass under it. Leaves its pen and
/// font set on the painter.
void paintSheetNote(QPainter& painter, const QPointF& baseline, const QString& text);
/// Top edge of the drawing area below the head, in pixels.
double sheetHead_px(const QWidget& widget);

} // namespace usar::widgets
