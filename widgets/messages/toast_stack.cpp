#include "widgets/messages/toast_stack.h"

#include <algorithm>

#include <QEvent>
#include <QLayout>
#include <QMouseEvent>

#include "widgets/style/form_parts.h"
#include "widgets/style/icons.h"
#include "widgets/style/theme.h"

namespace usar::widgets {

Toast::Toast(const Notification& notification, QWidget* parent) : QFrame(parent), key_(notification.key) {
    setProperty("role", "card");
    setFocusPolicy(Qt::NoFocus);
    setCursor(Qt::PointingHandCursor);
    setToolTip(tr("Click to see all notifications"));
    word_->setFont(themeFont(FontRole::Small));
    text_->setWordWrap(true);
    text_->setTextFormat(Qt::PlainText);
    auto* close = new QToolButton(this);
    close->setIcon(icon(QStringLiteral("clear")));
    close->setAutoRaise(true);
    close->setFocusPolicy(Qt::NoFocus);
    close->setCursor(Qt::ArrowCursor);
    close->setFixedSize(minimum_target, minimum_target);
    named(close, tr("Close this message"), tr("Close this message"));
    auto* grid = gridOf(this, {gap::small, gap::tiny, gap::tiny, gap::small}, gap::small, 0);
    grid->addWidget(sign_, 0, 0);
    grid->addWidget(word_, 0, 1);
    grid->addWidget(close, 0, 2);
    grid->addWidget(text_, 1, 1, 1, 2);
    offer_->setFocusPolicy(Qt::NoFocus);
    offer_->setCursor(Qt::ArrowCursor);
    offer_->setMinimumHeight(minimum_target);
    grid->addWidget(offer_, 2, 1, 1, 2, Qt::AlignRight);
    grid->setColumnStretch(1, 1);
    life_.setSingleShot(true);
    life_.setInterval(notification.severity == Severity::Note ? note_lifetime_ms : lifetime_ms);
    connect(&life_, &QTimer::timeout, this, &Toast::finished);
    connect(close, &QToolButton::clicked, this, &Toast::finished);
    connect(offer_, &QPushButton::clicked, this, &Toast::offerTaken);
    show(notification);
    onThemeChange(this, [this] { paintSign(); });
}

void Toast::show(const Notification& notification) {
    severity_ = notification.severity;
    const QString word = severityWord(severity_);
    word_->setText(notification.count > 1 ? word + QStringLiteral("  ×%1").arg(notification.count) : word);
    text_->setText(notification.text);
    setAccessibleName(word + QStringLiteral(": ") + notification.text);
    offer_->setText(notification.offer.text);
    offer_->setToolTip(notification.offer.help);
    offer_->setAccessibleDescription(notification.offer.help);
    offer_->setVisible(notification.offers());
    paintSign();
    startLife();
    QWidget::show();
}

void Toast::startLife() {
    life_.stop();
    if (offer_->isHidden())
        life_.start();
}

void Toast::paintSign() {
    sign_->setPixmap(icon(severityIcon(severity_), severityColor(severity_)).pixmap(16, 16));
    setRole(word_, severityRole(severity_));
}

void Toast::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton && rect().contains(event->position().toPoint()))
        emit clicked();
}

void Toast::enterEvent(QEnterEvent* event) {
    life_.stop();
    QFrame::enterEvent(event);
}

void Toast::leaveEvent(QEvent* event) {
    startLife();
    QFrame::leaveEvent(event);
}

namespace {
constexpr int widest_px = 360;
}

ToastStack::ToastStack(QWidget* covered, NotificationModel* model) : QObject(covered), covered_(covered) {
    covered->installEventFilter(this);
    connect(model, &NotificationModel::pushed, this, &ToastStack::push);
    connect(model, &NotificationModel::cured, this, &ToastStack::take);
    connect(this, &ToastStack::offerTaken, model, &NotificationModel::takeOffer);
    connect(model, &QAbstractItemModel::modelReset, this, [this] {
        while (!toasts_.empty())
            take(QString(toasts_.back()->key()));
    });
}

void ToastStack::push(const Notification& notification) {
    if (!notification.toast)
        return;
    if (Toast* known = toastOf(notification.key)) {
        known->show(notification);
        arrange();
        return;
    }
    if (count() == most)
        take(QString(toasts_.front()->key()));
    auto* toast = new Toast(notification, covered_);
    connect(toast, &Toast::finished, this, [this, toast] { take(QString(toast->key())); });
    connect(toast, &Toast::offerTaken, this, [this, toast] { emit offerTaken(toast->key()); });
    connect(toast, &Toast::clicked, this, [this, toast] {
        const QString key = toast->key();
        take(key);
        emit openRequested(key);
    });
    toasts_.push_back(toast);
    arrange();
}

void ToastStack::take(const QString& key) {
    Toast* toast = toastOf(key);
    if (!toast)
        return;
    std::erase(toasts_, toast);
    toast->hide();
    toast->deleteLater();
    arrange();
}

Toast* ToastStack::toastOf(const QString& key) const {
    const auto found = std::ranges::find(toasts_, key, &Toast::key);
    return found == toasts_.end() ? nullptr : *found;
}

void ToastStack::arrange() {
    const int width = std::min(widest_px, covered_->width() - 2 * gap::medium);
    int bottom = covered_->height() - gap::medium;
    for (auto toast = toasts_.rbegin(); toast != toasts_.rend(); ++toast) {
        const int height = (*toast)->layout()->totalHeightForWidth(width);
        (*toast)->setGeometry(covered_->width() - gap::medium - width, bottom - height, width, height);
        (*toast)->raise();
        bottom -= height + gap::small;
    }
}

bool ToastStack::eventFilter(QObject* watched, QEvent* event) {
    if (watched == covered_ && event->type() == QEvent::Resize)
        arrange();
    return QObject::eventFilter(watched, event);
}

} // namespace usar::widgets
