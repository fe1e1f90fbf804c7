// The framed sheet that every painted instrument is drawn on.
#pragma once

#include <optional>
#include <vector>

#include <QPainter>
#include <QPointF>
#include <QString>
#include <QWidget>

namespace usar::widgets {

/// Frame and ground over the whole widget; antialiasing is on afterwards.
void paintSheet(QPainter& painter, const QWidget& widget);
/// The same with the sentence that says what will appear here.
void paintEmptySheet(QPainter& painter, const QWidget& widget, const QString& sentence);
/// Name on the left, the newest figure on the right. Stale figures are grey, and the name says the word.
void paintSheetHead(QPainter& painter, const QWidget& widget, const QString& name, const QString& value, bool stale);
/// The ground in a cross-section: neighbors are joined and filled down to `bottom_px`; a point that is absent breaks
/// the line, because nothing is known there.
void paintGround(QPainter& painter, const std::vector<std::optional<QPointF>>& line, double bottom_px, bool stale);
/// A small note within the drawing, on a backing of its own: lines may pass under it. Ink and font stay set.
void paintSheetNote(QPainter& painter, const QPointF& baseline, const QString& text);
/// Where the drawing begins: under the head, in pixels from the top.
double sheetHead_px(const QWidget& widget);

} // namespace usar::widgets
