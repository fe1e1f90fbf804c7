#include "widgets/commands/command_list_model.h"

#include <algorithm>

#include <QIcon>

namespace usar::widgets {

std::optional<int> matchScore(const QString& typed, const QString& text) {
    int score = 0;
    for (const QString& word : typed.split(u' ', Qt::SkipEmptyParts)) {
        const qsizetype at = text.indexOf(word, 0, Qt::CaseInsensitive);
        if (at < 0)
            return std::nullopt;
        score += at == 0 ? 3 : !text[at - 1].isLetterOrNumber() ? 2 : 1;
    }
    return score;
}

CommandListModel::CommandListModel(const CommandRegistry& registry, QObject* parent)
    : QAbstractListModel(parent)
    , registry_(registry) {
    setFilter({});
}

void CommandListModel::setFilter(const QString& typed) {
    std::vector<std::pair<int, const CommandRegistry::Command*>> scored;
    for (const auto& command : registry_.commands()) {
        if (!command->action->isEnabled())
            continue;
        const QString text = command->spec.text + QStringLiteral(" ") + command->spec.group;
        if (const auto score = matchScore(typed, text))
            scored.emplace_back(*score, command.get());
    }
    std::ranges::stable_sort(scored, std::ranges::greater(), [](const auto& entry) { return entry.first; });
    beginResetModel();
    rows_.clear();
    for (const auto& [score, command] : scored)
        rows_.push_back(command);
    endResetModel();
}

QAction* CommandListModel::actionAt(const QModelIndex& index) const {
    return index.isValid() ? rows_[static_cast<std::size_t>(index.row())]->action : nullptr;
}

int CommandListModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

QVariant CommandListModel::data(const QModelIndex& index, int role) const {
    const auto& command = *rows_[static_cast<std::size_t>(index.row())];
    switch (role) {
    case Qt::DisplayRole:
        return command.spec.text;
    case Qt::DecorationRole:
        return command.action->icon();
    case Qt::ToolTipRole:
        return command.action->toolTip();
    case GroupRole:
        return command.spec.group;
    case ShortcutRole:
        return command.spec.shortcuts.isEmpty() ? QString()
                                                : command.spec.shortcuts.front().toString(QKeySequence::NativeText);
    default:
        return {};
    }
}

} // namespace usar::widgets
