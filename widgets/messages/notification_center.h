// The tab in which every error and event can be read again: grouped, counted, and grayed out when over.
#pragma once

#include <QAction>
#include <QLabel>
#include <QListView>
#include <QToolButton>
#include <QWidget>

#include "widgets/models/messages/notification_model.h"
#include "widgets/style/form_parts.h"

namespace usar::widgets {

class EmptyState;

/// Owns the model; toasts are made from it (toast_stack.h). Notifications that arrive while the tab is visible count as
/// read, and showing it marks all as read. Nothing here is modal or takes the focus. Texts are complete sentences: what
/// happened, to what, what to do. GUI thread.
class NotificationCenter : public QWidget {
    Q_OBJECT
public:
    explicit NotificationCenter(QWidget* parent = nullptr);

    NotificationModel* model() const { return model_; }
    QSize sizeHint() const override { return {400, 220}; }

public slots:
    /// `key` identifies the problem: further reports with the same key are counted, not listed separately. Warnings and
    /// errors are also shown as toasts, unless `toast` says otherwise; a note that the user waits for ("Saved 5 files")
    /// deserves one. An `offer` is a button beside the sentence; NotificationModel::offerTaken is emitted when it is
    /// clicked. `when` is wall time.
    void push(const QString& key, usar::Severity severity, const QString& text,
              std::optional<bool> toast = std::nullopt, const usar::widgets::Offer& offer = {},
              const QDateTime& when = QDateTime::currentDateTime());

    /// The problem with this key is over; its row stays, grayed out.
    void cured(const QString& key) { model_->cure(key); }

signals:
    /// For the tab's title.
    void unreadChanged(int unread);
    /// Double-click or Return: show the place that the notification refers to.
    void activated(const QString& key);

protected:
    void showEvent(QShowEvent* event) override;

private:
    QWidget* makeTools();
    void copySelected();
    /// Updates the action for the offer of the current row.
    void showOffer();
    void updateState();

    NotificationModel* model_ = new NotificationModel(this);
    QListView* view_ = new QListView(this);
    QLabel* summary_ = new ElidedLabel(this);
    QAction* take_offer_ = nullptr;
    QToolButton* clear_cured_ = nullptr;
    QToolButton* clear_all_ = nullptr;
    EmptyState* empty_state_;
};

} // namespace usar::widgets
