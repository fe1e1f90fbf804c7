// The palette's list: commands that match what was typed, best first.
#pragma once

#include <vector>

#include <QAbstractListModel>

#include "widgets/command_registry.h"

namespace usar::widgets {

/// How well `typed` describes `text`: every word must occur, word starts count more; nothing for no match. Case is
/// ignored; an empty text matches all equally.
std::optional<int> matchScore(const QString& typed, const QString& text);

/// Rows are enabled commands only, in order of score, then of registration. GUI thread; the registry outlives it.
class CommandListModel : public QAbstractListModel {
    Q_OBJECT
public:
    enum Role { ShortcutRole = Qt::UserRole, GroupRole };

    CommandListModel(const CommandRegistry& registry, QObject* parent = nullptr);

    /// Asks again which commands are enabled, so call it when the palette opens.
    void setFilter(const QString& typed);
    /// Nothing for an invalid index. The registry owns the action.
    QAction* actionAt(const QModelIndex& index) const;

    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;

private:
    const CommandRegistry& registry_;
    std::vector<const CommandRegistry::Command*> rows_;
};

} // namespace usar::widgets
