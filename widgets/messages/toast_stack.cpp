#include "widgets/messages/toast_stack.h"

#include <algorithm>

#include <QEvent>
#include <QLayout>

#include "widgets/messages/toast.h"
#include "widgets/style/theme.h"

namespace usar::widgets {

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

void ToastStack::setBottomMargin(int margin_px) {
    bottom_margin_px_ = margin_px;
    arrange();
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
    const bool note = notification.severity == Severity::Note;
    auto* toast = new Toast(notification, note ? std::min(note_lifetime_ms, lifetime_ms_) : lifetime_ms_, covered_);
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
    int bottom = covered_->height() - bottom_margin_px_;
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
