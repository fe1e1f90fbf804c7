#include "widgets/style/sheet.h"

#include <QFontMetrics>

#include "widgets/style/theme.h"

namespace usar::widgets {

void paintSheet(QPainter& painter, const QWidget& widget) {
    const Tokens& t = tokens();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(t.line, 1.0));
    painter.setBrush(t.surface);
    painter.drawRoundedRect(QRectF(widget.rect()).adjusted(0.5, 0.5, -0.5, -0.5), 4.0, 4.0);
}

void paintEmptySheet(QPainter& painter, const QWidget& widget, const QString& sentence) {
    paintSheet(painter, widget);
    painter.setPen(tokens().text_muted);
    painter.drawText(widget.rect().adjusted(gap::small, 0, -gap::small, 0), Qt::AlignCenter | Qt::TextWordWrap,
                     sentence);
}

void paintSheetHead(QPainter& painter, const QWidget& widget, const QString& name, const QString& value, bool stale) {
    const Tokens& t = tokens();
    const QRectF head(gap::small, gap::tiny, widget.width() - 2.0 * gap::small, widget.fontMetrics().height());
    painter.setPen(t.text_muted);
    painter.drawText(head, Qt::AlignLeft, stale ? QObject::tr("%1 (stale)").arg(name) : name);
    painter.setPen(stale ? t.stale : t.text);
    painter.drawText(head, Qt::AlignRight, value);
}

void paintSheetNote(QPainter& painter, const QPointF& baseline, const QString& text) {
    painter.setFont(themeFont(FontRole::Small));
    QColor back = tokens().surface;
    back.setAlphaF(0.85f);
    const QFontMetricsF metrics(painter.font());
    const QRectF box(baseline - QPointF(2.0, metrics.ascent()),
                     QSizeF(metrics.horizontalAdvance(text) + 4.0, metrics.height()));
    painter.fillRect(box, back);
    painter.setPen(tokens().text_muted);
    painter.drawText(baseline, text);
}

void paintGround(QPainter& painter, const std::vector<std::optional<QPointF>>& line, double bottom_px, bool stale) {
    const QColor ink = stale ? tokens().stale : tokens().ok;
    QColor fill = ink;
    fill.setAlphaF(0.16f);
    QPolygonF piece;
    const auto flush = [&] {
        if (piece.size() > 1) {
            const QPolygonF foot{QPointF(piece.last().x(), bottom_px), QPointF(piece.first().x(), bottom_px)};
            painter.setPen(Qt::NoPen);
            painter.setBrush(fill);
            painter.drawPolygon(piece + foot);
            painter.setPen(QPen(ink, 2.0));
            painter.setBrush(Qt::NoBrush);
            painter.drawPolyline(piece);
        }
        piece.clear();
    };
    for (const std::optional<QPointF>& point : line)
        point ? (void)(piece << *point) : flush();
    flush();
}

double sheetHead_px(const QWidget& widget) {
    return gap::tiny + widget.fontMetrics().height() + 2.0;
}

} // namespace usar::widgets
