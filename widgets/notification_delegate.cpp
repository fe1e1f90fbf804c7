#include "widgets/notification_delegate.h"

#include <algorithm>
#include <cmath>

#include <QListView>
#include <QPainter>
#include <QTextLayout>

#include "widgets/icons.h"
#include "widgets/models/notification_model.h"
#include "widgets/theme.h"

namespace usar::widgets {

namespace {

constexpr int icon_px = 16;
constexpr int left_px = gap::small + icon_px + gap::small;

const Notification& notificationAt(const QModelIndex& index) {
    return static_cast<const NotificationModel*>(index.model())->row(index.row());
}

QString metaText(const Notification& n) {
    QStringList parts = {severityWord(n.severity), n.last.toString(QStringLiteral("HH:mm:ss"))};
    if (n.count > 1)
        parts << QStringLiteral("×%1").arg(n.count);
    if (n.cured)
        parts << NotificationDelegate::tr("cured");
    return parts.join(QStringLiteral("  ·  "));
}

/// At words, and within one only where it is wider than the row.
QTextOption wrapping() {
    QTextOption option;
    option.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
    return option;
}

int textHeight(const QString& text, int width) {
    QTextLayout layout(text, themeFont());
    layout.setTextOption(wrapping());
    layout.beginLayout();
    qreal height = 0.0;
    for (QTextLine line = layout.createLine(); line.isValid(); line = layout.createLine()) {
        line.setLineWidth(width);
        height += line.height();
    }
    layout.endLayout();
    return static_cast<int>(std::ceil(height));
}

} // namespace

void NotificationDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                                 const QModelIndex& index) const {
    const Notification& n = notificationAt(index);
    const Tokens& t = tokens();
    painter->save();
    if (option.state & QStyle::State_Selected)
        painter->fillRect(option.rect, t.raised);
    if (option.state & QStyle::State_HasFocus) {
        painter->setPen(t.accent);
        painter->drawRect(option.rect.adjusted(0, 0, -1, -1));
    }
    const QColor sign = n.cured ? t.stale : severityColor(n.severity);
    const QPoint corner = option.rect.topLeft() + QPoint(gap::small, gap::tiny + 2);
    icon(n.cured ? QStringLiteral("check") : severityIcon(n.severity), sign)
        .paint(painter, QRect(corner, QSize(icon_px, icon_px)));
    QRect rest = option.rect.adjusted(left_px, gap::tiny, -gap::small, -gap::tiny);
    painter->setFont(themeFont());
    painter->setPen(n.cured ? t.stale : t.text);
    painter->drawText(QRectF(rest), n.text, wrapping());
    rest.setTop(rest.bottom() - QFontMetrics(themeFont(FontRole::Small)).height());
    painter->setFont(themeFont(FontRole::Small));
    painter->setPen(n.cured ? t.stale : t.text_muted);
    painter->drawText(rest, Qt::AlignLeft | Qt::AlignBottom, metaText(n));
    painter->restore();
}

QSize NotificationDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
    const auto* view = qobject_cast<const QAbstractItemView*>(option.widget);
    const int width = std::max(120, view ? view->viewport()->width() : option.rect.width());
    const int text = textHeight(notificationAt(index).text, width - left_px - gap::small);
    return {width, text + QFontMetrics(themeFont(FontRole::Small)).height() + 3 * gap::tiny};
}

} // namespace usar::widgets
