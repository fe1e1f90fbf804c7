#include "widgets/commands/command_palette.h"

#include <algorithm>
#include <map>

#include <QIcon>
#include <QKeyEvent>
#include <QPainter>
#include <QStyledItemDelegate>

#include "widgets/style/form_parts.h"
#include "widgets/style/theme.h"

namespace usar::widgets {
namespace {

/// Paints the text on the left, group and shortcut muted on the right.
class CommandDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
        QStyledItemDelegate::paint(painter, option, index);
        const bool selected = option.state & QStyle::State_Selected;
        const QString shortcut = index.data(CommandListModel::ShortcutRole).toString();
        QString text = index.data(CommandListModel::GroupRole).toString();
        if (!shortcut.isEmpty())
            text += QStringLiteral("    ") + shortcut;
        painter->setPen(selected ? inkOn(tokens().accent) : tokens().text_muted);
        painter->drawText(option.rect.adjusted(0, 0, -gap::small, 0), Qt::AlignRight | Qt::AlignVCenter, text);
    }
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
        return {QStyledItemDelegate::sizeHint(option, index).width(), 28};
    }
};

} // namespace

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

CommandPalette::CommandPalette(const CommandRegistry& registry, QWidget* window)
    : QFrame(window, Qt::Popup)
    , model_(new CommandListModel(registry, this)) {
    setProperty("role", "card");
    setAccessibleName(tr("Command palette"));
    line_->setPlaceholderText(tr("Type a command"));
    named(line_, tr("Command"), tr("Finds commands by any part of their name; Return runs the marked one, Esc closes"));
    line_->setMinimumHeight(minimum_target);
    line_->setClearButtonEnabled(true);
    list_->setModel(model_);
    list_->setItemDelegate(new CommandDelegate(list_));
    list_->setFocusPolicy(Qt::NoFocus);
    list_->setAccessibleName(tr("Matching commands"));
    list_->setFrameShape(QFrame::NoFrame);
    laidOut(new QVBoxLayout(this), {gap::small, gap::small, gap::small, gap::small}, gap::small, {line_, list_});
    line_->installEventFilter(this);
    connect(line_, &QLineEdit::textChanged, this, [this](const QString& text) {
        model_->setFilter(text);
        list_->setCurrentIndex(model_->index(0));
    });
    connect(line_, &QLineEdit::returnPressed, this, &CommandPalette::run);
    connect(list_, &QListView::clicked, this, &CommandPalette::run);
}

void CommandPalette::open() {
    const QWidget* window = parentWidget();
    const QSize size(std::min(560, window->width() - 2 * gap::large), std::min(400, window->height() - 2 * gap::large));
    resize(size);
    move(window->mapToGlobal(QPoint((window->width() - size.width()) / 2, gap::large)));
    line_->clear();
    model_->setFilter({});
    list_->setCurrentIndex(model_->index(0));
    show();
    line_->setFocus();
}

bool CommandPalette::eventFilter(QObject* watched, QEvent* event) {
    static const std::map<int, int> steps = {
        {Qt::Key_Down, 1}, {Qt::Key_Up, -1}, {Qt::Key_PageDown, 8}, {Qt::Key_PageUp, -8}};
    if (watched == line_ && event->type() == QEvent::KeyPress)
        if (const auto step = steps.find(static_cast<QKeyEvent*>(event)->key()); step != steps.end())
            return choose(step->second), true;
    return QFrame::eventFilter(watched, event);
}

void CommandPalette::choose(int by) {
    const int row = std::clamp(list_->currentIndex().row() + by, 0, std::max(0, model_->rowCount() - 1));
    list_->setCurrentIndex(model_->index(row));
}

void CommandPalette::run() {
    QAction* action = model_->actionAt(list_->currentIndex());
    if (!action)
        return;
    hide();
    action->trigger();
}

} // namespace usar::widgets
