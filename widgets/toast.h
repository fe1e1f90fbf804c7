// One passing message over the window: severity, sentence, count, what is offered, and a button that takes it away.
#pragma once

#include <QFrame>
#include <QLabel>
#include <QPushButton>
#include <QTimer>

#include "widgets/models/notification_model.h"

namespace usar::widgets {

/// A child widget, never a window, and without focus: keys stay where they are. Goes after its lifetime, which does
/// not run while the mouse is over it; one that offers something stays until that is taken or withdrawn. GUI thread.
class Toast : public QFrame {
    Q_OBJECT
public:
    Toast(const Notification& notification, int lifetime_ms, QWidget* parent);

    /// Of the notification that it shows.
    const QString& key() const { return key_; }
    /// The same trouble again: new text and count, and a whole lifetime.
    void show(const Notification& notification);
    /// The sentence, without word and count.
    QString text() const { return text_->text(); }

signals:
    /// Anywhere but on a button.
    void clicked();
    void offerTaken();
    /// By its button or because its time is over.
    void finished();

protected:
    void mouseReleaseEvent(QMouseEvent* event) override;
    void enterEvent(QEnterEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    /// Icon and word in the severity's color of the current theme.
    void paintSign();
    void startLife();

    QString key_;
    Severity severity_ = Severity::Note;
    QLabel* sign_;
    QLabel* word_;
    QLabel* text_;
    QPushButton* offer_;
    QTimer life_{this};
};

} // namespace usar::widgets
