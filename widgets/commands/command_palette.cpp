#include "widgets/commands/command_palette.h"

#include <algorithm>
#include <map>
#include <utility>

#include <QIcon>
#include <QKeyEvent>
#include <QPainter>
#include <QStyledItemDelegate>

#include "widgets/style/empty_state.h"
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

/// An icon without a line, so that the text begins where it does beside other icons.
QIcon noIcon() {
    QPixmap blank(64, 64);
    blank.fill(Qt::transparent);
    return QIcon(blank);
}

QString wishOf(const CommandSpec& spec) {
    return spec.wish.isEmpty() ? spec.text : spec.wish;
}

/// Score of one typed word; 0: it does not match.
int scoreOf(const QString& typed, const QString& text, const QStringList& words) {
    if (const qsizetype at = text.indexOf(typed, 0, Qt::CaseInsensitive); at >= 0)
        return at == 0 ? 3 : !text[at - 1].isLetterOrNumber() ? 2 : 1;
    const QString start = QStringLiteral(" ") + typed;
    return std::ranges::any_of(
        words, [&](const QString& word) { return (QStringLiteral(" ") + word).contains(start, Qt::CaseInsensitive); });
}

} // namespace

std::optional<int> matchScore(const QString& typed, const QString& text, const QStringList& words) {
    int score = 0;
    for (const QString& word : typed.split(u' ', Qt::SkipEmptyParts)) {
        const int part = scoreOf(word, text, words);
        if (part == 0)
            return std::nullopt;
        score += part;
    }
    return score;
}

CommandListModel::CommandListModel(const CommandRegistry& registry, QObject* parent)
    : QAbstractListModel(parent)
    , registry_(registry) {
    setFilter({});
}

void CommandListModel::setFilter(const QString& typed) {
    beginResetModel();
    if (typed.isEmpty())
        offers_ = registry_.offers();
    constexpr int not_now = -1000; // Below every score of what is possible.
    std::vector<std::pair<int, Row>> scored;
    for (const auto& command : registry_.commands()) {
        const bool possible = command->action->isEnabled();
        const QString text = wishOf(command->spec) + QStringLiteral(" ") + command->spec.group;
        const auto score = matchScore(typed, text, command->spec.words);
        if (score && (possible || !typed.isEmpty()))
            scored.emplace_back(possible ? *score : *score + not_now, Row{command.get(), nullptr});
    }
    if (!typed.isEmpty())
        for (const PaletteOffer& offer : offers_)
            if (const auto score = matchScore(typed, offer.text + QStringLiteral(" ") + offer.group, offer.words))
                scored.emplace_back(*score, Row{nullptr, &offer});
    std::ranges::stable_sort(scored, std::ranges::greater(), [](const auto& entry) { return entry.first; });
    rows_.clear();
    for (const auto& [score, row] : scored)
        rows_.push_back(row);
    endResetModel();
}

void CommandListModel::run(const QModelIndex& index) {
    if (!index.isValid())
        return;
    const Row row = rows_[static_cast<std::size_t>(index.row())];
    if (row.command) {
        QAction* const action = row.command->action;
        if (!row.command->spec.wish.isEmpty() && action->isChecked())
            return emit action->triggered(true); // "Show Camera" must not hide it.
        return action->trigger();
    }
    const auto run = row.offer->run; // A copy, because it may open the palette again.
    run();
}

int CommandListModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

QVariant CommandListModel::data(const QModelIndex& index, int role) const {
    const Row& row = rows_[static_cast<std::size_t>(index.row())];
    if (row.command)
        return dataOf(*row.command, role);
    switch (role) {
    case Qt::DisplayRole:
        return row.offer->text;
    case Qt::DecorationRole:
        return noIcon();
    case GroupRole:
        return row.offer->group;
    default:
        return {};
    }
}

QVariant CommandListModel::dataOf(const CommandRegistry::Command& command, int role) const {
    const CommandSpec& spec = command.spec;
    switch (role) {
    case Qt::DisplayRole:
        return wishOf(spec);
    case Qt::DecorationRole:
        return command.action->icon().isNull() ? noIcon() : command.action->icon();
    case Qt::ToolTipRole:
        return command.action->toolTip();
    case GroupRole:
        return command.action->isEnabled() ? spec.group : tr("%1, not now").arg(spec.group);
    case ShortcutRole:
        return spec.shortcuts.isEmpty() ? QString() : spec.shortcuts.front().toString(QKeySequence::NativeText);
    default:
        return {};
    }
}

Qt::ItemFlags CommandListModel::flags(const QModelIndex& index) const {
    const Qt::ItemFlags flags = QAbstractListModel::flags(index);
    const auto* const command = index.isValid() ? rows_[static_cast<std::size_t>(index.row())].command : nullptr;
    return command && !command->action->isEnabled() ? flags & ~Qt::ItemIsEnabled : flags;
}

CommandPalette::CommandPalette(const CommandRegistry& registry, QWidget* window)
    : QFrame(window, Qt::Popup)
    , model_(new CommandListModel(registry, this))
    , nothing_(new EmptyState(list_->viewport(), tr("No command matches"), tr("Try another word, or fewer letters."))) {
    setProperty("role", "card");
    setAccessibleName(tr("Command palette"));
    line_->setPlaceholderText(tr("Type a command, robot, world or mission"));
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
    connect(line_, &QLineEdit::textChanged, this, &CommandPalette::filter);
    connect(line_, &QLineEdit::returnPressed, this, &CommandPalette::run);
    connect(list_, &QListView::clicked, this, [this](const QModelIndex& row) {
        if (row.flags() & Qt::ItemIsEnabled)
            run();
    });
}

void CommandPalette::open() {
    const QWidget* window = parentWidget();
    const QSize size(std::min(560, window->width() - 2 * gap::large), std::min(400, window->height() - 2 * gap::large));
    resize(size);
    move(window->mapToGlobal(QPoint((window->width() - size.width()) / 2, gap::large)));
    line_->clear();
    filter({});
    show();
    line_->setFocus();
}

void CommandPalette::filter(const QString& typed) {
    model_->setFilter(typed);
    list_->setCurrentIndex(model_->index(0));
    nothing_->setVisible(model_->rowCount() == 0);
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
    const QModelIndex marked = list_->currentIndex();
    if (!marked.isValid())
        return;
    hide();
    model_->run(marked);
}

} // namespace usar::widgets
