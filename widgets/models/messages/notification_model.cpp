#include "widgets/models/messages/notification_model.h"

#include <algorithm>

#include "widgets/style/theme.h"

namespace usar::widgets {

QString severityWord(Severity severity) {
    const QString words[] = {NotificationModel::tr("Note"), NotificationModel::tr("Warning"),
                             NotificationModel::tr("Error")};
    return words[static_cast<std::size_t>(severity)];
}

QString severityIcon(Severity severity) {
    const QString names[] = {QStringLiteral("note"), QStringLiteral("warning"), QStringLiteral("error")};
    return names[static_cast<std::size_t>(severity)];
}

QColor severityColor(Severity severity) {
    const QColor colors[] = {tokens().accent, tokens().caution, tokens().danger};
    return colors[static_cast<std::size_t>(severity)];
}

const char* severityRole(Severity severity) {
    constexpr const char* roles[] = {"accent", "caution", "danger"};
    return roles[static_cast<std::size_t>(severity)];
}

void NotificationModel::push(const QString& key, Severity severity, const QString& text, const QDateTime& when,
                             std::optional<bool> toast, const Offer& offer) {
    Notification fresh{key, severity, text, when, 1, false, true, toast.value_or(severity != Severity::Note), offer};
    if (const std::optional<int> known = indexOf(key)) {
        fresh.count = row(*known).cured ? 1 : row(*known).count + 1;
        if (*known > 0) {
            beginMoveRows({}, *known, *known, {}, 0);
            std::rotate(rows_.begin(), rows_.begin() + *known, rows_.begin() + *known + 1);
            endMoveRows();
        }
        change(0, fresh);
    } else {
        insert(0, fresh);
    }
    if (rowCount() > capacity)
        remove(capacity);
    tellUnread();
    emit pushed(fresh);
}

void NotificationModel::cure(const QString& key) {
    const std::optional<int> known = indexOf(key);
    if (!known || row(*known).cured)
        return;
    Notification healed = row(*known);
    healed.cured = true;
    healed.unread = false;
    change(*known, healed);
    tellUnread();
    emit cured(key);
}

void NotificationModel::cureAll(const QString& start) {
    QStringList keys; // first, because a receiver of `cured` may push another row
    for (const Notification& each : rows_)
        if (each.key.startsWith(start) && each.severity != Severity::Note)
            keys << each.key;
    for (const QString& key : keys)
        cure(key);
}

void NotificationModel::takeOffer(const QString& key) {
    if (const std::optional<int> known = indexOf(key); known && row(*known).offers())
        emit offerTaken(key);
}

void NotificationModel::clear() {
    beginResetModel();
    rows_.clear();
    endResetModel();
    tellUnread();
}

void NotificationModel::clearCured() {
    for (int i = rowCount() - 1; i >= 0; --i)
        if (row(i).cured)
            remove(i);
}

void NotificationModel::markRead() {
    for (Notification& each : rows_)
        each.unread = false;
    tellUnread();
}

int NotificationModel::unread() const {
    return static_cast<int>(std::ranges::count_if(rows_, &Notification::unread));
}

int NotificationModel::openCount() const {
    return static_cast<int>(std::ranges::count_if(
        rows_, [](const Notification& each) { return !each.cured && each.severity != Severity::Note; }));
}

QVariant NotificationModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || (role != Qt::DisplayRole && role != Qt::AccessibleTextRole))
        return {};
    const Notification& n = row(index.row());
    QString text = severityWord(n.severity) + QStringLiteral(": ") + n.text;
    if (n.count > 1)
        text += QStringLiteral(" ×%1").arg(n.count);
    if (n.offers() && role == Qt::AccessibleTextRole)
        text += tr(" Press Return to do this: %1.").arg(n.offer.text);
    return n.cured ? text + QStringLiteral(" (") + tr("cured") + u')' : text;
}

void NotificationModel::tellUnread() {
    const int now = unread();
    if (now != std::exchange(told_unread_, now))
        emit unreadChanged(now);
}

} // namespace usar::widgets
