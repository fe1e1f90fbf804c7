#include "widgets/panels/reading_list_view.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "widgets/models/figures.h"
#include "widgets/style/theme.h"

namespace usar::widgets {
namespace {

constexpr double thinnest_bar_px = 24.0;

} // namespace

ReadingListView::ReadingListView(QWidget* parent) : Instrument(parent) {
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
}

int ReadingListView::rowHeight_px() const {
    return fontMetrics().height() + 1;
}

int ReadingListView::height_px() const {
    return static_cast<int>(sheetHead_px(*this)) + static_cast<int>(list_.rows.size()) * rowHeight_px() + gap::tiny;
}

void ReadingListView::setList(const ReadingList& list, Seconds now, bool linked) {
    const bool taller = list.rows.size() != list_.rows.size();
    const bool all_stale = !linked || list.stale(now);
    list_ = list;
    now_ = now;
    setAccessibleName(list.title);
    setToolTip(list.help);
    QStringList words;
    for (const ReadingRow& row : list.rows)
        words << (row.heard.stale(now) && !all_stale ? tr("%1, out of date").arg(row.text()) : row.text());
    if (std::exchange(words_, words) != words)
        showFresh(words.join(QStringLiteral(", ")));
    setStale(all_stale, list.heard.age(now), list.heard.period);
    if (taller)
        updateGeometry();
}

void ReadingListView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    paintSheet(painter, *this);
    paintHead(painter, list_.title);
    double name_px = 0.0;
    for (const ReadingRow& row : list_.rows)
        name_px = std::max(name_px, fontMetrics().horizontalAdvance(row.name) + 1.0);
    name_px = std::min(name_px, 0.45 * width());
    const double row_px = rowHeight_px();
    double y = sheetHead_px(*this);
    for (const ReadingRow& row : list_.rows) {
        paintRow(painter, row, QRectF(gap::small, y, width() - 2.0 * gap::small, row_px), name_px);
        y += row_px;
    }
}

void ReadingListView::paintRow(QPainter& painter, const ReadingRow& row, const QRectF& box, double name_px) const {
    const Tokens& t = tokens();
    const bool old = rowStale(row);
    painter.setPen(t.text_muted);
    painter.setFont(font());
    paintElided(painter, QRectF(box.left(), box.top(), name_px, box.height()).toRect(), row.name);
    const double unit_px = row.unit.isEmpty() ? 0.0 : fontMetrics().horizontalAdvance(row.unit) + gap::tiny;
    painter.drawText(box, Qt::AlignRight | Qt::AlignVCenter, row.unit);
    const double mark_px = row.mark == RowMark::None ? 0.0 : 8.0 + gap::tiny;
    const double left = box.left() + name_px + gap::small;
    const double value_room = box.right() - unit_px - left - mark_px;
    const QString value =
        fontMetrics().elidedText(row.value, Qt::ElideRight, static_cast<int>(std::max(0.0, value_room)));
    const double value_px = fontMetrics().horizontalAdvance(value);
    QFont figures = font();
    figures.setStrikeOut(old);
    painter.setFont(figures);
    painter.setPen(old ? t.stale : t.text);
    painter.drawText(box.adjusted(0.0, 0.0, -unit_px, 0.0), Qt::AlignRight | Qt::AlignVCenter, value);
    const double end = box.right() - unit_px - value_px;
    if (row.mark != RowMark::None) {
        const QColor color = old ? t.stale : row.mark == RowMark::On ? t.accent : t.text_muted;
        painter.setPen(QPen(color, 1.5));
        painter.setBrush(row.mark == RowMark::On ? QBrush(color) : QBrush(Qt::NoBrush));
        painter.drawEllipse(QPointF(end - gap::tiny - 4.0, box.center().y()), 3.5, 3.5);
    }
    // All bars end at the same place, before the widest figure.
    const double bar_end =
        box.right() - unit_px - fontMetrics().horizontalAdvance(QStringLiteral("−180.0")) - gap::small;
    if (row.share && bar_end - left > thinnest_bar_px)
        paintBar(painter, row, QRectF(left, std::round(box.center().y()) - 2.5, bar_end - left, 5.0));
}

void ReadingListView::paintBar(QPainter& painter, const ReadingRow& row, const QRectF& groove) const {
    const Tokens& t = tokens();
    painter.setPen(QPen(t.line, 1.0));
    painter.setBrush(t.raised);
    painter.drawRoundedRect(groove, 2.0, 2.0);
    const double zero = groove.left() + row.zero_share.value_or(0.0) * groove.width();
    const double at = groove.left() + *row.share * groove.width();
    const QColor color = rowStale(row) ? t.stale : t.accent;
    painter.fillRect(QRectF(std::min(zero, at), groove.top() + 1.0, std::abs(at - zero), groove.height() - 2.0),
                     faded(color, 0.6));
    painter.setPen(QPen(color, 2.0));
    painter.drawLine(QPointF(at, groove.top()), QPointF(at, groove.bottom()));
    if (!row.zero_share)
        return;
    painter.setPen(QPen(t.text_muted, 1.0));
    painter.drawLine(QPointF(zero, groove.top() - 1.0), QPointF(zero, groove.bottom() + 1.0));
}

} // namespace usar::widgets
