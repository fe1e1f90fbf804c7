// Temporary message over the window: severity, sentence, count, an optional offer, and a button that closes it.
#pragma once

#include <QFrame>
#include <QLabel>
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
    Toast(const Notification& notification, int lifetime_ms, QWidget* parent);

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

} // namespace usar::widgets
