#include "widgets/messages/notification_center.h"

#include <algorithm>
#include <cmath>

#include <QClipboard>
#include <QGuiApplication>
#include <QMouseEvent>
#include <QPainter>
#include <QStyledItemDelegate>
#include <QTextLayout>

#include "widgets/style/empty_state.h"
#include "widgets/style/icons.h"
#include "widgets/style/sheet.h"
#include "widgets/style/theme.h"
#include "widgets/style/tool_button.h"

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
        parts << NotificationCenter::tr("cured");
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

/// Paints a notification: severity icon, the sentence with line breaks, a muted line with severity, time and count, and
/// a button if something is offered. Rows are as high as their text needs at the view's width.
class NotificationDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
        const Notification& n = notificationAt(index);
        const Tokens& t = tokens();
        painter->save();
        paintRowGround(*painter, option);
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

    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
        const auto* view = qobject_cast<const QAbstractItemView*>(option.widget);
        const int width = std::max(120, view ? view->viewport()->width() : option.rect.width());
        const Notification& n = notificationAt(index);
        return {width, textHeight(n.text, width - left_px - gap::small) + footHeight(n) + 3 * gap::tiny};
    }

    /// A click on the button accepts the offer.
    bool editorEvent(QEvent* event, QAbstractItemModel* model, const QStyleOptionViewItem& option,
                     const QModelIndex& index) override {
        const Notification& n = notificationAt(index);
        if (event->type() != QEvent::MouseButtonRelease || !n.offers())
            return false;
        const auto* const mouse = static_cast<QMouseEvent*>(event);
        if (mouse->button() != Qt::LeftButton || !offerRect(option.rect, n).contains(mouse->position().toPoint()))
            return false;
        static_cast<NotificationModel*>(model)->takeOffer(QString(n.key));
        return true;
    }
};

} // namespace

NotificationCenter::NotificationCenter(QWidget* parent) : QWidget(parent) {
    laidOut(new QVBoxLayout(this), {}, 0, {makeTools(), view_})->setStretchFactor(view_, 1);
    setUpPaintedRows(view_, model_, new NotificationDelegate(view_), tr("Notifications"));
    view_->setResizeMode(QListView::Adjust);
    view_->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    view_->setSelectionMode(QAbstractItemView::ExtendedSelection);
    view_->setContextMenuPolicy(Qt::ActionsContextMenu);
    connect(addRowAction(view_, tr("Copy"), QKeySequence::Copy), &QAction::triggered, this,
            &NotificationCenter::copySelected);
    take_offer_ = addRowAction(view_, {}, Qt::Key_Return);
    connect(take_offer_, &QAction::triggered, this,
            [this] { model_->takeOffer(model_->row(view_->currentIndex().row()).key); });
    connect(view_->selectionModel(), &QItemSelectionModel::currentChanged, this, &NotificationCenter::showOffer);
    connect(view_, &QListView::activated, this,
            [this](const QModelIndex& index) { emit activated(model_->row(index.row()).key); });
    empty_state_ = new EmptyState(view_, tr("Nothing to report"),
                                  tr("Errors and events appear here and stay until you clear them."));
    connect(model_, &NotificationModel::unreadChanged, this, &NotificationCenter::unreadChanged);
    for (const auto signal : {&QAbstractItemModel::rowsInserted, &QAbstractItemModel::rowsRemoved})
        connect(model_, signal, this, &NotificationCenter::updateState);
    connect(model_, &QAbstractItemModel::modelReset, this, &NotificationCenter::updateState);
    connect(model_, &QAbstractItemModel::dataChanged, this, &NotificationCenter::updateState);
    updateState();
}

void NotificationCenter::showOffer() {
    const QModelIndex current = view_->currentIndex();
    const bool offers = current.isValid() && model_->row(current.row()).offers();
    take_offer_->setEnabled(offers); // Otherwise Return would have no effect in rows without an offer.
    take_offer_->setVisible(offers);
    take_offer_->setText(offers ? model_->row(current.row()).offer.text : QString());
}

QWidget* NotificationCenter::makeTools() {
    auto* tools = new QWidget(this);
    summary_->setProperty("role", "muted");
    auto* row = laidOut(new QHBoxLayout(tools), {gap::small, gap::tiny, gap::tiny, gap::tiny}, gap::tiny, {summary_});
    row->setStretchFactor(summary_, 1);
    const auto add = [&](const QString& text, const QString& tip) {
        auto* button = makeToolButton(tip, tools);
        button->setText(text);
        row->addWidget(button);
        return button;
    };
    clear_cured_ = add(tr("Clear cured"), tr("Removes the notifications of problems that are over"));
    clear_all_ = add(tr("Clear all"), tr("Removes all notifications, including those of open problems"));
    connect(clear_cured_, &QToolButton::clicked, model_, &NotificationModel::clearCured);
    connect(clear_all_, &QToolButton::clicked, model_, &NotificationModel::clear);
    return tools;
}

void NotificationCenter::push(const QString& key, Severity severity, const QString& text, std::optional<bool> toast,
                              const Offer& offer, const QDateTime& when) {
    model_->push(key, severity, text, when, toast, offer);
    if (isVisible())
        model_->markRead();
}

void NotificationCenter::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    model_->markRead();
}

void NotificationCenter::copySelected() {
    QStringList lines;
    for (const QModelIndex& index : view_->selectionModel()->selectedIndexes())
        lines << model_->row(index.row()).last.toString(Qt::ISODate) + u' ' + index.data().toString();
    QGuiApplication::clipboard()->setText(lines.join(u'\n'));
}

void NotificationCenter::updateState() {
    const int all = model_->rowCount();
    const int cured = model_->curedCount();
    summary_->setText(all == 0 ? QString() : tr("%1 open, %2 cured").arg(model_->openCount()).arg(cured));
    clear_cured_->setEnabled(cured > 0);
    clear_all_->setEnabled(all > 0);
    empty_state_->setVisible(all == 0);
    showOffer();
}

} // namespace usar::widgets
