// What the person should know, newest first; the same trouble again is one row with a count, and it is marked when
// cured.
#pragma once

#include <deque>
#include <optional>

#include <QAbstractListModel>
#include <QDateTime>

#include "core/base/diagnostics.h"

namespace usar::widgets {

/// What a person may want next, as a button beside the sentence; who hears `offerTaken` does it.
struct Offer {
    QString text; ///< "Start R2 again"; empty: nothing is offered
    QString help; ///< what will happen, with the shortcut
};

struct Notification {
    QString key; ///< what it is about: the same key is the same trouble ("link", "export")
    Severity severity = Severity::Note;
    QString text;   ///< what happened, to what, what to do
    QDateTime last; ///< wall time of the newest report
    int count = 1;
    bool cured = false;
    bool unread = true;
    bool toast = true; ///< shown in passing, too
    Offer offer = {};  ///< of the newest report

    bool offers() const { return !offer.text.isEmpty() && !cured; }
};

/// "Note", "Warning", "Error".
QString severityWord(Severity severity);
/// Name for `icon()`, and its color in the current theme.
QString severityIcon(Severity severity);
QColor severityColor(Severity severity);

/// Keeps the newest `capacity` groups. DisplayRole is the whole sentence; views paint from `row`. GUI thread.
class NotificationModel : public QAbstractListModel {
    Q_OBJECT
public:
    static constexpr int capacity = 500;
    using QAbstractListModel::QAbstractListModel;

    /// Moves the group of `key` to the top, with the newest text and severity, or makes one; a cured one is open again
    /// and counts from 1. Warnings and errors are toasts unless `toast` says otherwise.
    void push(const QString& key, Severity severity, const QString& text, const QDateTime& when,
              std::optional<bool> toast = std::nullopt, const Offer& offer = {});
    /// The trouble is over, and nothing is offered any more. An unknown key is no news.
    void cure(const QString& key);
    /// The person wants what was offered; nothing where nothing is.
    void takeOffer(const QString& key);
    /// Takes away open ones too, without a word that they were cured.
    void clear();
    /// Takes away what is cured.
    void clearCured();
    /// Somebody looks at the list now.
    void markRead();

    /// Groups that came, or came again, since the last markRead and are not cured.
    int unread() const;
    /// Groups whose trouble is not over.
    int openCount() const;
    /// 0 is the newest; the reference holds until the next change.
    const Notification& row(int index) const { return rows_[static_cast<std::size_t>(index)]; }
    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;

signals:
    /// After the row is in its place, new or moved to the top.
    void pushed(const usar::widgets::Notification& notification);
    /// Once: a cure of what is cured says nothing.
    void cured(const QString& key);
    void offerTaken(const QString& key);
    /// Only when the number is another one.
    void unreadChanged(int unread);

private:
    std::optional<int> indexOf(const QString& key) const;
    void tellUnread();

    std::deque<Notification> rows_; ///< newest first
    int told_unread_ = 0;
};

} // namespace usar::widgets
