// Temporary messages over the window, and their stack at its bottom right, at most three.
#pragma once

#include <vector>

#include <QFrame>
#include <QLabel>
#include <QObject>
#include <QPushButton>
#include <QTimer>

#include "widgets/models/messages/notification_model.h"

namespace usar::widgets {

/// A child widget, never a window, and without focus: keys stay where they are. Finishes after its lifetime, which does
/// not run while the mouse is over it; a toast with an offer stays until the offer is accepted or withdrawn. GUI
/// thread.
class Toast : public QFrame {
    Q_OBJECT
public:
    static constexpr int lifetime_ms = 8000;      ///< warnings and errors stay this long
    static constexpr int note_lifetime_ms = 6000; ///< shorter, because good news is read faster

    Toast(const Notification& notification, QWidget* parent);

    /// Key of the notification that it shows.
    const QString& key() const { return key_; }
    /// Shows a new report of the same problem: new text and count, and a new lifetime.
    void show(const Notification& notification);
    /// The sentence without severity and count.
    QString text() const { return text_->text(); }

signals:
    /// The toast was clicked outside of its buttons.
    void clicked();
    /// The user accepted the offer.
    void offerTaken();
    /// The toast was closed by its button, or its lifetime is over; the owner should remove it.
    void finished();

protected:
    void mouseReleaseEvent(QMouseEvent* event) override;
    void enterEvent(QEnterEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    /// Sets icon and severity in the color of the current theme.
    void paintSign();
    /// Restarts the lifetime, unless there is an offer.
    void startLife();

    QString key_;
    Severity severity_ = Severity::Note;
    QLabel* sign_ = new QLabel(this);
    QLabel* word_ = new QLabel(this);
    QLabel* text_ = new QLabel(this);
    QPushButton* offer_ = new QPushButton(this);
    QTimer life_{this};
};

/// Shows a toast for each notification that asks for one (by default warnings and errors), newest at the bottom. A new
/// report with the same key updates its toast, and a cure removes it. `covered` owns the stack and must outlive the
/// model's signals. GUI thread.
class ToastStack : public QObject {
    Q_OBJECT
public:
    /// Number of toasts on the screen at most; a newer one removes the oldest.
    static constexpr int most = 3;

    ToastStack(QWidget* covered, NotificationModel* model);

    /// Number of toasts on the screen, 0..`most`.
    int count() const { return static_cast<int>(toasts_.size()); }

signals:
    /// A toast was clicked; show the notifications. The toast is removed.
    void openRequested(const QString& key);
    /// The button of a toast was clicked; the model is informed and informs everybody else.
    void offerTaken(const QString& key);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void push(const Notification& notification);
    /// Hides the toast at once and deletes it later, because the toast itself may be the caller.
    void take(const QString& key);
    Toast* toastOf(const QString& key) const;
    /// Places the toasts from the bottom right corner upward.
    void arrange();

    QWidget* covered_;
    std::vector<Toast*> toasts_; ///< oldest first; children of `covered_`
};

} // namespace usar::widgets
