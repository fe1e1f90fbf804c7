// List model of notifications, newest first; repeated reports of the same problem share a row with a count, and the row
// is marked when the problem is over.
#pragma once

#include <algorithm>
#include <optional>

#include <QColor>
#include <QDateTime>

#include "core/base/diagnostics.h"
#include "widgets/models/row_model.h"

namespace usar::widgets {

/// An action that a notification offers as a button beside its sentence; whoever connects to `offerTaken` performs it.
struct Offer {
    QString text; ///< "Start R2 again"; empty: no offer
    QString help; ///< says what the button will do, with its shortcut
};

/// One row: all reports of one problem.
struct Notification {
    QString key; ///< identifies the problem: reports with the same key share a row ("link", "export")
    Severity severity = Severity::Note;
    QString text;       ///< says what happened, to what, and what to do
    QDateTime last;     ///< wall time of the newest report
    int count = 1;      ///< number of reports since the problem was last cured
    bool cured = false; ///< the problem is over
    bool unread = true;
    bool toast = true; ///< also shown as a toast
    Offer offer = {};  ///< from the newest report

    bool offers() const { return !offer.text.isEmpty() && !cured; }
};

/// "Note", "Warning", "Error".
QString severityWord(Severity severity);
/// Name of the severity's icon for `icon()`, and its color in the current theme.
QString severityIcon(Severity severity);
QColor severityColor(Severity severity);
/// The role that gives a label this color, see form_parts.h.
const char* severityRole(Severity severity);

/// Keeps the newest `capacity` rows, the newest one first. DisplayRole is the whole sentence; views paint from `row`.
/// GUI thread.
class NotificationModel : public RowModel<Notification> {
    Q_OBJECT
public:
    static constexpr int capacity = 500;
    using RowModel::RowModel;

    /// Moves the row of `key` to the top with the newest text and severity, or adds one; a cured row is open again and
    /// its count restarts at 1. `when` is wall time. Warnings and errors are shown as toasts unless `toast` says
    /// otherwise.
    void push(const QString& key, Severity severity, const QString& text, const QDateTime& when,
              std::optional<bool> toast = std::nullopt, const Offer& offer = {});
    /// The problem is over; its offer is withdrawn. An unknown or already cured key changes nothing.
    void cure(const QString& key);
    /// All problems whose keys begin with `start` are over.
    void cureAll(const QString& start);
    /// The user accepts the offer; has no effect if there is none.
    void takeOffer(const QString& key);
    /// Removes all rows, also open ones, without emitting `cured`.
    void clear();
    /// Removes the cured rows.
    void clearCured();
    /// Marks all rows as read, because the user is looking at the list.
    void markRead();

    /// Number of rows that were reported since the last markRead and are not cured.
    int unread() const;
    /// Number of warnings and errors that are not cured; a note tells of no problem.
    int openCount() const;
    /// Number of problems that are over.
    int curedCount() const { return static_cast<int>(std::ranges::count(rows_, true, &Notification::cured)); }
    QVariant data(const QModelIndex& index, int role) const override;

signals:
    /// Emitted after the row is in its place, whether added or moved to the top.
    void pushed(const usar::widgets::Notification& notification);
    /// Emitted once per problem: curing a cured one emits nothing.
    void cured(const QString& key);
    /// The user accepted the offer of this key.
    void offerTaken(const QString& key);
    /// Emitted only when the number changed.
    void unreadChanged(int unread);

private:
    std::optional<int> indexOf(const QString& key) const { return find(&Notification::key, key); }
    void tellUnread();

    int told_unread_ = 0;
};

} // namespace usar::widgets
