#include "widgets/messages/notification_delegate.h"

#include <algorithm>
#include <cmath>

#include <QListView>
#include <QMouseEvent>
#include <QPainter>
#include <QTextLayout>

#include "widgets/models/messages/notification_model.h"
#include "widgets/style/icons.h"
#include "widgets/style/theme.h"

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

/// Breaks lines at words, and within a word only if it is wider than the row.
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

/// Returns the height of the line below the sentence.
int footHeight(const Notification& n) {
    return n.offers() ? minimum_target : QFontMetrics(themeFont(FontRole::Small)).height();
}

QRect offerRect(const QRect& row, const Notification& n) {
    const int width = QFontMetrics(themeFont()).horizontalAdvance(n.offer.text) + 2 * gap::medium;
    return {row.right() - gap::small - width, row.bottom() - gap::tiny - minimum_target, width, minimum_target};
}

void paintOffer(QPainter& painter, const QRect& row, const Notification& n) {
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(tokens().accent);
    painter.setBrush(tokens().raised);
    const QRect box = offerRect(row, n);
    painter.drawRoundedRect(QRectF(box).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
    painter.setPen(tokens().text);
    painter.setFont(themeFont());
    painter.drawText(box, Qt::AlignCenter, n.offer.text);
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
    rest.setTop(rest.bottom() - footHeight(n));
    painter->setFont(themeFont(FontRole::Small));
    painter->setPen(n.cured ? t.stale : t.text_muted);
    painter->drawText(rest, Qt::AlignLeft | (n.offers() ? Qt::AlignVCenter : Qt::AlignBottom), metaText(n));
    if (n.offers())
        paintOffer(*painter, option.rect, n);
    painter->restore();
}

QSize NotificationDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
    const auto* view = qobject_cast<const QAbstractItemView*>(option.widget);
    const int width = std::max(120, view ? view->viewport()->width() : option.rect.width());
    const Notification& n = notificationAt(index);
    return {width, textHeight(n.text, width - left_px - gap::small) + footHeight(n) + 3 * gap::tiny};
}

bool NotificationDelegate::editorEvent(QEvent* event, QAbstractItemModel* model, const QStyleOptionViewItem& option,
                                       const QModelIndex& index) {
    const Notification& n = notificationAt(index);
    if (event->type() != QEvent::MouseButtonRelease || !n.offers())
        return false;
    const auto* const mouse = static_cast<QMouseEvent*>(event);
    if (mouse->button() != Qt::LeftButton || !offerRect(option.rect, n).contains(mouse->position().toPoint()))
        return false;
    static_cast<NotificationModel*>(model)->takeOffer(QString(n.key));
    return true;
}

} // namespace usar::widgets
