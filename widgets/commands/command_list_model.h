// List model of the command palette: the commands that match the typed text, best match first.
#pragma once

#include <vector>

#include <QAbstractListModel>

#include "widgets/commands/command_registry.h"

namespace usar::widgets {

/// Scores how well `typed` matches `text`; higher is better. Every word must occur; matches at the start of a word
/// count more. nullopt: no match. Case is ignored; an empty `typed` matches everything equally.
std::optional<int> matchScore(const QString& typed, const QString& text);

/// Rows are the enabled commands only, by score, then by registration. GUI thread; the registry must outlive the model.
class CommandListModel : public QAbstractListModel {
    Q_OBJECT
public:
    /// ShortcutRole is the shortcut as text, GroupRole the command's group.
    enum Role { ShortcutRole = Qt::UserRole, GroupRole };

    CommandListModel(const CommandRegistry& registry, QObject* parent = nullptr);

    /// Lists the commands that are enabled now and match; call it whenever the palette opens.
    void setFilter(const QString& typed);
    /// Returns nullptr for an invalid index. The registry owns the action.
    QAction* actionAt(const QModelIndex& index) const;

    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;

private:
    const CommandRegistry& registry_;
    std::vector<const CommandRegistry::Command*> rows_;
};

} // namespace usar::widgets
