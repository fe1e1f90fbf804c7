#include "widgets/messages/notification_center.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QVBoxLayout>

#include "widgets/messages/notification_delegate.h"
#include "widgets/style/elided_label.h"
#include "widgets/style/empty_state.h"
#include "widgets/style/theme.h"
#include "widgets/style/tool_button.h"

namespace usar::widgets {

NotificationCenter::NotificationCenter(QWidget* parent) : QWidget(parent) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(makeTools());
    column->addWidget(view_, 1);
    view_->setModel(model_);
    view_->setItemDelegate(new NotificationDelegate(view_));
    view_->setResizeMode(QListView::Adjust);
    view_->setFrameShape(QFrame::NoFrame);
    view_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    view_->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    view_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    view_->setSelectionMode(QAbstractItemView::ExtendedSelection);
    view_->setContextMenuPolicy(Qt::ActionsContextMenu);
    view_->setAccessibleName(tr("Notifications"));
    setFocusProxy(view_);
    connect(addRowAction(tr("Copy"), QKeySequence::Copy), &QAction::triggered, this, &NotificationCenter::copySelected);
    take_offer_ = addRowAction({}, Qt::Key_Return);
    connect(take_offer_, &QAction::triggered, this,
            [this] { model_->takeOffer(model_->row(view_->currentIndex().row()).key); });
    connect(view_->selectionModel(), &QItemSelectionModel::currentChanged, this, &NotificationCenter::showOffer);
    connect(view_, &QListView::activated, this,
            [this](const QModelIndex& index) { emit activated(model_->row(index.row()).key); });
    empty_state_ = new EmptyState(view_);
    empty_state_->setText(tr("Nothing to report"), tr("Errors and events appear here and stay until you clear them."));
    connect(model_, &NotificationModel::unreadChanged, this, &NotificationCenter::unreadChanged);
    for (const auto signal : {&QAbstractItemModel::rowsInserted, &QAbstractItemModel::rowsRemoved})
        connect(model_, signal, this, &NotificationCenter::updateState);
    connect(model_, &QAbstractItemModel::modelReset, this, &NotificationCenter::updateState);
    connect(model_, &QAbstractItemModel::dataChanged, this, &NotificationCenter::updateState);
    updateState();
}

/// Makes an action for the context menu; its shortcut works while the list has the focus.
QAction* NotificationCenter::addRowAction(const QString& text, const QKeySequence& keys) {
    auto* action = new QAction(text, view_);
    action->setShortcut(keys);
    action->setShortcutContext(Qt::WidgetShortcut);
    view_->addAction(action);
    return action;
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
    auto* row = new QHBoxLayout(tools);
    row->setContentsMargins(gap::small, gap::tiny, gap::tiny, gap::tiny);
    row->setSpacing(gap::tiny);
    summary_->setProperty("role", "muted");
    row->addWidget(summary_, 1);
    const auto add = [&](const QString& text, const QString& tip) {
        auto* button = makeToolButton(tip, tools);
        button->setText(text);
        row->addWidget(button);
        return button;
    };
    clear_cured_ = add(tr("Clear cured"), tr("Takes away what is over"));
    clear_all_ = add(tr("Clear all"), tr("Takes everything away, also what is not cured"));
    connect(clear_cured_, &QToolButton::clicked, model_, &NotificationModel::clearCured);
    connect(clear_all_, &QToolButton::clicked, this, &NotificationCenter::clearAll);
    return tools;
}

void NotificationCenter::push(const QString& key, Severity severity, const QString& text, bool toast) {
    push(key, severity, text, QDateTime::currentDateTime(), toast);
}

void NotificationCenter::push(const QString& key, Severity severity, const QString& text, const QDateTime& when,
                              std::optional<bool> toast) {
    model_->push(key, severity, text, when, toast);
    if (isVisible())
        model_->markRead();
}

void NotificationCenter::push(const QString& key, Severity severity, const QString& text, const Offer& offer) {
    model_->push(key, severity, text, QDateTime::currentDateTime(), true, offer);
    if (isVisible())
        model_->markRead();
}

void NotificationCenter::cured(const QString& key) {
    model_->cure(key);
}

void NotificationCenter::clearAll() {
    model_->clear();
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
    const int open = model_->openCount();
    summary_->setText(all == 0 ? QString() : tr("%1 open, %2 cured").arg(open).arg(all - open));
    clear_cured_->setEnabled(open < all);
    clear_all_->setEnabled(all > 0);
    empty_state_->setVisible(all == 0);
    showOffer();
}

} // namespace usar::widgets
