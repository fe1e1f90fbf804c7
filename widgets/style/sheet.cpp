#include "widgets/style/sheet.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QFontMetrics>
#include <QHelpEvent>
#include <QToolTip>

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
    painter.drawText(head, Qt::AlignLeft, name);
    painter.setPen(stale ? t.stale : t.text);
    painter.drawText(head, Qt::AlignRight, value);
}

void paintSheetNote(QPainter& painter, const QPointF& baseline, const QString& text) {
    painter.setFont(themeFont(FontRole::Small));
    const QFontMetricsF metrics(painter.font());
    const QRectF box(baseline - QPointF(2.0, metrics.ascent()),
                     QSizeF(metrics.horizontalAdvance(text) + 4.0, metrics.height()));
    painter.fillRect(box, faded(tokens().surface, 0.85));
    painter.setPen(tokens().text_muted);
    painter.drawText(baseline, text);
}

void paintGround(QPainter& painter, const std::vector<std::optional<QPointF>>& line, double bottom_px, bool stale) {
    const QColor ink = stale ? tokens().stale : tokens().ok;
    QPolygonF piece;
    const auto flush = [&] {
        if (piece.size() > 1) {
            const QPolygonF foot{QPointF(piece.last().x(), bottom_px), QPointF(piece.first().x(), bottom_px)};
            painter.setPen(Qt::NoPen);
            painter.setBrush(faded(ink, 0.16));
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

void paintCard(QPainter& painter, const QRectF& card) {
    painter.setBrush(faded(tokens().raised, 0.92));
    painter.setPen(QPen(tokens().line, 1.0));
    painter.drawRoundedRect(card.adjusted(0.5, 0.5, -0.5, -0.5), 4.0, 4.0);
}

void fillInStrips(QPainter& painter, const QRectF& rectangle, const QColor& color) {
    constexpr int rows = 64;
    const QRect whole(QPoint(qRound(rectangle.left()), qRound(rectangle.top())),
                      QPoint(qRound(rectangle.right()) - 1, qRound(rectangle.bottom()) - 1));
    for (int top = whole.top(); top <= whole.bottom(); top += rows)
        painter.fillRect(QRect(whole.left(), top, whole.width(), std::min(rows, whole.bottom() + 1 - top)), color);
}

void frameInStrips(QPainter& painter, const QRectF& rectangle, double width_px, const QColor& color) {
    const QRectF inner = rectangle.adjusted(width_px, width_px, -width_px, -width_px);
    fillInStrips(painter, QRectF(rectangle.topLeft(), QPointF(rectangle.right(), inner.top())), color);
    fillInStrips(painter, QRectF(QPointF(rectangle.left(), inner.bottom()), rectangle.bottomRight()), color);
    fillInStrips(painter, QRectF(QPointF(rectangle.left(), inner.top()), QPointF(inner.left(), inner.bottom())), color);
    fillInStrips(painter, QRectF(inner.topRight(), QPointF(rectangle.right(), inner.bottom())), color);
}

void dashFrame(QPainter& painter, const QRectF& rectangle, const QRectF& sight, const QColor& color) {
    constexpr int width = 2;
    constexpr int dash = 8;
    constexpr int period = 12;
    const QRect edge(QPoint(qRound(rectangle.left()) - 1, qRound(rectangle.top()) - 1),
                     QPoint(qRound(rectangle.right()), qRound(rectangle.bottom())));
    const QRect seen = sight.toAlignedRect() & edge;
    const auto firstDash = [](int from, int seen_from) { return from + (seen_from - from) / period * period; };
    for (int x = firstDash(edge.left(), seen.left()); x <= seen.right(); x += period)
        for (const int y : {edge.top(), edge.bottom() + 1 - width})
            painter.fillRect(QRect(x, y, std::min(dash, edge.right() + 1 - x), width), color);
    for (int y = firstDash(edge.top(), seen.top()); y <= seen.bottom(); y += period)
        for (const int x : {edge.left(), edge.right() + 1 - width})
            painter.fillRect(QRect(x, y, width, std::min(dash, edge.bottom() + 1 - y)), color);
}

void paintRowGround(QPainter& painter, const QStyleOptionViewItem& option) {
    if (option.state & QStyle::State_Selected)
        painter.fillRect(option.rect, tokens().raised);
    if (option.state & QStyle::State_HasFocus) {
        painter.setPen(tokens().accent);
        painter.drawRect(option.rect.adjusted(0, 0, -1, -1));
    }
}

void paintElided(QPainter& painter, const QRect& box, const QString& text) {
    painter.drawText(box, Qt::AlignLeft | Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(text, Qt::ElideRight, box.width()));
}

QPen dashedPen(const QColor& color, double width_px, const QList<qreal>& pattern) {
    QPen pen(color, width_px);
    pen.setDashPattern(pattern);
    return pen;
}

void Instrument::setStale(bool stale, Seconds age, std::optional<Seconds> period) {
    age_ = age;
    const QString rate_text = !stale && period && period->count() > 0.0
                                  ? QString::number(1.0 / period->count(), 'f', 1) + QStringLiteral(" Hz")
                                  : QString();
    if (std::exchange(rate_text_, rate_text) != rate_text)
        update();
    // Whole seconds, so that it is not painted anew in each frame.
    const QString age_text =
        stale && std::isfinite(age.count()) ? tr("%1 s").arg(std::llround(age.count())) : QString();
    const bool same_age = std::exchange(age_text_, age_text) == age_text;
    if (std::exchange(stale_, stale) == stale && same_age)
        return;
    describe(description_);
    update();
}

void Instrument::showFresh(const QString& description) {
    stale_ = false;
    age_text_.clear();
    describe(description);
    update();
}

void Instrument::describe(const QString& words) {
    description_ = words;
    setAccessibleDescription(!stale_               ? words
                             : age_text_.isEmpty() ? tr("%1, out of date").arg(words)
                                                   : tr("%1, out of date, %2 old").arg(words, age_text_));
}

QString Instrument::headName(const QString& name) const {
    return !stale_               ? name
           : age_text_.isEmpty() ? tr("%1 (stale)").arg(name)
                                 : tr("%1 (stale, %2)").arg(name, age_text_);
}

void Instrument::paintHead(QPainter& painter, const QString& name, const QString& value) const {
    paintSheetHead(painter, *this, headName(name), value, stale_);
    const QFont small = themeFont(FontRole::Small);
    const double left = gap::small + fontMetrics().horizontalAdvance(name) + gap::small;
    const double value_px = value.isEmpty() ? 0.0 : fontMetrics().horizontalAdvance(value) + gap::small;
    const double room = width() - gap::small - value_px - left;
    if (rate_text_.isEmpty() || QFontMetricsF(small).horizontalAdvance(rate_text_) > room)
        return;
    painter.save();
    painter.setFont(small);
    painter.setPen(tokens().text_muted);
    painter.drawText(QPointF(left, gap::tiny + fontMetrics().ascent()), rate_text_);
    painter.restore();
}

QString Instrument::toolTipNow() const {
    if (toolTip().isEmpty() || !std::isfinite(age_.count()))
        return toolTip();
    const QString age_text = tr("newest %1 s old").arg(age_.count(), 0, 'f', 1);
    return toolTip() + QLatin1Char('\n') +
           (rate_text_.isEmpty() ? age_text : rate_text_ + QStringLiteral(", ") + age_text);
}

bool Instrument::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip || toolTip().isEmpty())
        return QWidget::event(event);
    QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(), toolTipNow(), this, {}, toolTipDuration());
    return true;
}

QColor Instrument::ink(const QColor& fresh) const {
    return stale_ ? tokens().stale : fresh;
}

} // namespace usar::widgets
