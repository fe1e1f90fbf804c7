// Stack of temporary messages at the bottom right of a window, at most three.
#pragma once

#include <vector>

#include <QObject>

#include "widgets/models/messages/notification_model.h"

namespace usar::widgets {

class Toast;

/// Shows a toast for each notification that asks for one (by default warnings and errors), newest at the bottom. A new
/// report with the same key updates its toast, and a cure removes it. `covered` owns the stack and must outlive the
/// model's signals. GUI thread.
class ToastStack : public QObject {
    Q_OBJECT
public:
    static constexpr int most = 3;
    static constexpr int default_lifetime_ms = 8000;
    static constexpr int note_lifetime_ms = 6000; ///< shorter, because good news is read faster

    ToastStack(QWidget* covered, NotificationModel* model);

    /// Lifetime of future toasts; notes never stay longer than `note_lifetime_ms`.
    void setLifetime(int milliseconds) { lifetime_ms_ = milliseconds; }
    /// Room that stays free below the toasts, for a status bar.
    void setBottomMargin(int margin_px);
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
    int lifetime_ms_ = default_lifetime_ms;
    int bottom_margin_px_ = 16;
};

} // namespace usar::widgets
