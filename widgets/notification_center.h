// The tab where every error and event can be read again: grouped, counted, greyed when cured.
#pragma once

#include <QAction>
#include <QLabel>
#include <QListView>
#include <QToolButton>
#include <QWidget>

#include "widgets/models/notification_model.h"

namespace usar::widgets {

class EmptyState;

/// Owns the model; toasts are made from it (toast_stack.h). What is pushed while it is seen counts as read, and opening
/// it reads all. Nothing here is modal and nothing takes the focus. Texts are whole sentences: what happened, to what,
/// what to do. GUI thread.
class NotificationCenter : public QWidget {
    Q_OBJECT
public:
    explicit NotificationCenter(QWidget* parent = nullptr);

    NotificationModel* model() const { return model_; }
    /// Groups, not reports: 137 lost links are one.
    int unread() const { return model_->unread(); }
    /// Says that nothing happened yet; shown while there are no rows.
    EmptyState* emptyState() const { return empty_state_; }
    QSize sizeHint() const override { return {400, 220}; }

public slots:
    /// `key` says what it is about: the same key again is counted, not listed again. `when` is wall time. Warnings and
    /// errors are toasts too, unless `toast` says otherwise.
    void push(const QString& key, usar::Severity severity, const QString& text,
              const QDateTime& when = QDateTime::currentDateTime(), std::optional<bool> toast = std::nullopt);
    /// The same, now: a note that a person waits for ("Saved 5 files") is worth a toast.
    void push(const QString& key, usar::Severity severity, const QString& text, bool toast);
    /// The same, now, with a button beside the sentence; `NotificationModel::offerTaken` follows a click on it.
    void push(const QString& key, usar::Severity severity, const QString& text, const usar::widgets::Offer& offer);
    /// The trouble with that key is over; its row stays, greyed.
    void cured(const QString& key);
    /// Takes open ones away too: the person has read them.
    void clearAll();

signals:
    /// For the tab's title.
    void unreadChanged(int unread);
    /// Double-click or Return: show the place that it is about.
    void activated(const QString& key);

protected:
    void showEvent(QShowEvent* event) override;

private:
    QWidget* makeTools();
    void copySelected();
    QAction* addRowAction(const QString& text, const QKeySequence& keys);
    /// Of the current row.
    void showOffer();
    void updateState();

    NotificationModel* model_;
    QListView* view_;
    QLabel* summary_;
    QAction* take_offer_ = nullptr;
    QToolButton* clear_cured_ = nullptr;
    QToolButton* clear_all_ = nullptr;
    EmptyState* empty_state_;
};

} // namespace usar::widgets
