// Passing messages at the bottom right of a window: warnings and errors as they come, at most three.
#pragma once

#include <vector>

#include <QObject>

#include "widgets/models/notification_model.h"

namespace usar::widgets {

class Toast;

/// Shows what is pushed into the model as a toast (by its rule: warnings and errors), newest at the bottom; the same
/// key again updates its toast, and a cure takes it away. `covered` owns this and must outlive the model's signals. GUI
/// thread.
class ToastStack : public QObject {
    Q_OBJECT
public:
    static constexpr int most = 3;
    static constexpr int default_lifetime_ms = 8000;
    static constexpr int note_lifetime_ms = 6000; ///< good news is read faster

    ToastStack(QWidget* covered, NotificationModel* model);

    /// Of toasts that come from now on; notes never stay longer than theirs.
    void setLifetime(int milliseconds) { lifetime_ms_ = milliseconds; }
    /// Room kept free below the toasts, for a status bar.
    void setBottomMargin(int margin_px);
    /// Toasts on the screen now, `most` at the most.
    int count() const { return static_cast<int>(toasts_.size()); }

signals:
    /// A toast was clicked: open the notifications.
    void openRequested(const QString& key);
    /// By the button of a toast; the model tells everybody.
    void offerTaken(const QString& key);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void push(const Notification& notification);
    /// Hides at once and deletes later, for the toast itself may be asking.
    void take(const QString& key);
    Toast* toastOf(const QString& key) const;
    /// From the bottom right corner upward.
    void arrange();

    QWidget* covered_;
    std::vector<Toast*> toasts_; ///< oldest first; children of `covered_`
    int lifetime_ms_ = default_lifetime_ms;
    int bottom_margin_px_ = 16;
};

} // namespace usar::widgets
