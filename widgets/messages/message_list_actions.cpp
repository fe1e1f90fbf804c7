// The actions on the lines of a MessageList.
#include <algorithm>

#include <QClipboard>
#include <QGuiApplication>
#include <QJsonDocument>

#include "widgets/messages/message_list.h"
#include "widgets/models/messages/message_parts.h"
#include "widgets/style/icons.h"

namespace usar::widgets {

namespace {

constexpr std::size_t most_sent_again = 100;
constexpr qsizetype longest_clip = 16 << 20; ///< in characters; more than most editors accept

QString textOf(const MessageRow& row, const QString&) {
    return QString::fromStdString(row.text);
}

QString jsonTextOf(const MessageRow& row, const QString& robot) {
    return QString::fromUtf8(QJsonDocument(jsonOf(row, robot)).toJson(QJsonDocument::Compact));
}

} // namespace

void MessageList::makeActions() {
    const struct {
        QAction*& action;
        QString text;
        QString help;
        const char* icon_name = "";
        std::optional<bool> on = {}; ///< as it is at the beginning; nullopt: not checkable
    } rows[] = {
        {actions_.copy, tr("Copy lines"), tr("The selected lines with number, time and direction")},
        {actions_.copy_text, tr("Copy text of lines"), tr("The selected lines as they are on the wire")},
        {actions_.copy_json, tr("Copy lines as JSON"),
         tr("The selected lines with fields, units, diagnostics and cause")},
        {actions_.copy_shown, tr("Copy all shown lines"), tr("Copies the text of all shown lines to the clipboard")},
        {actions_.save, tr("Save shown lines…"), tr("As text, or as JSON lines"), "export"},
        {actions_.resend, tr("Send again"), tr("Sends the selected commands once more, as they were"), "reset"},
        {actions_.only_type, tr("Show only this type"), tr("Hides all other types of lines")},
        {actions_.hide_type, tr("Hide this type"), tr("Lines of the selected line's type are not shown")},
        {actions_.no_filter, tr("Show all lines"), tr("Removes all filters")},
        {actions_.cause, tr("Go to its cause"), tr("The line that made us send the selected command")},
        {actions_.details, tr("Show details"), tr("Shows values, units, errors and cause of the selected line"), "note",
         false},
        {actions_.only_trouble, tr("Only problems"), tr("Only lines with errors, warnings or notes"), "warning", false},
        {actions_.pause, tr("Pause messages"), tr("Freezes the list; new lines are kept and shown later"), "pause",
         false},
        {actions_.follow, tr("Follow messages"), tr("Stays at the newest line"), "land", true},
        {actions_.all_robots, tr("Messages of all robots"),
         tr("Shows the messages of all robots, or only those of the selected one"), "robot", false},
        {actions_.clear, tr("Clear messages"), tr("Removes all lines"), "clear"},
    };
    for (const auto& [action, text, help, icon_name, on] : rows) {
        action = new QAction(icon(icon_name), text, this);
        action->setToolTip(help);
        action->setCheckable(on.has_value());
        action->setChecked(on.value_or(false));
    }
    actions_.copy->setShortcut(QKeySequence::Copy);
    actions_.copy->setShortcutContext(Qt::WidgetShortcut);
}

void MessageList::wireActions() {
    view_->setContextMenuPolicy(Qt::ActionsContextMenu);
    const auto separator = [this] {
        auto* line = new QAction(this);
        line->setSeparator(true);
        return line;
    };
    view_->addActions({actions_.copy, actions_.copy_text, actions_.copy_json, separator(), actions_.resend,
                       actions_.cause, actions_.details, separator(), actions_.only_type, actions_.hide_type,
                       actions_.no_filter, actions_.all_robots, separator(), actions_.copy_shown, actions_.save});
    connect(actions_.copy, &QAction::triggered, this, [this] { copyRows(selectedRows(), tabbedText); });
    connect(actions_.copy_text, &QAction::triggered, this, [this] { copyRows(selectedRows(), textOf); });
    connect(actions_.copy_json, &QAction::triggered, this, [this] { copyRows(selectedRows(), jsonTextOf); });
    connect(actions_.copy_shown, &QAction::triggered, this, &MessageList::copyShown);
    connect(actions_.save, &QAction::triggered, this, &MessageList::saveRequested);
    connect(actions_.resend, &QAction::triggered, this, &MessageList::resend);
    connect(actions_.only_type, &QAction::triggered, this, [this] { filterByCurrent(true); });
    connect(actions_.hide_type, &QAction::triggered, this, [this] { filterByCurrent(false); });
    connect(actions_.no_filter, &QAction::triggered, this, [this] { setFilter({}); });
    connect(actions_.cause, &QAction::triggered, this, [this] {
        if (const auto rows = selectedRows(1); !rows.empty())
            if (const auto cause = model_->serialOf(rows.front()->connection, Direction::In, rows.front()->trigger))
                jumpTo(*cause);
    });
    connect(actions_.details, &QAction::toggled, this, [this](bool on) {
        detail_->setVisible(on);
        if (on && selected_)
            detail_->show(*model_, *selected_);
    });
    connect(actions_.pause, &QAction::toggled, this, [this] {
        flushSoon();
        updateState();
    });
    connect(actions_.follow, &QAction::toggled, this, [this](bool on) {
        if (on)
            view_->scrollToBottom();
    });
    connect(actions_.all_robots, &QAction::toggled, this, &MessageList::applyFilter);
    connect(actions_.clear, &QAction::triggered, this, &MessageList::clear);
}

std::vector<const MessageRow*> MessageList::selectedRows(std::size_t limit) const {
    QItemSelection selection = view_->selectionModel()->selection();
    std::ranges::sort(selection, {}, &QItemSelectionRange::top);
    std::vector<const MessageRow*> rows;
    for (const QItemSelectionRange& range : selection)
        for (int row = range.top(); row <= range.bottom() && rows.size() < limit; ++row)
            rows.push_back(&model_->row(row));
    return rows;
}

void MessageList::copyRows(const std::vector<const MessageRow*>& rows, RowText text) {
    QString all;
    for (const MessageRow* row : rows) {
        if (!all.isEmpty())
            all += u'\n';
        all += text(*row, model_->connectionName(row->connection));
        if (all.size() > longest_clip) {
            emit failed(
                tr("%n lines are too much for the clipboard. Save them to a file instead, or filter them first.",
                   nullptr, static_cast<int>(rows.size())));
            return;
        }
    }
    QGuiApplication::clipboard()->setText(all);
}

void MessageList::copyShown() {
    std::vector<const MessageRow*> rows;
    for (int row = 0; row < model_->rowCount(); ++row)
        rows.push_back(&model_->row(row));
    copyRows(rows, textOf);
}

void MessageList::saveShown(const QString& path) {
    saver_->save(path);
    updateState();
}

void MessageList::resend() {
    QStringList lines;
    std::optional<ConnectionId> connection;
    for (const MessageRow* row : selectedRows(most_sent_again))
        if (row->direction == Direction::Out && connection.value_or(row->connection) == row->connection) {
            connection = row->connection;
            lines << QString::fromStdString(row->text);
        }
    if (connection)
        emit resendRequested(*connection, lines);
}

void MessageList::filterByCurrent(bool only) {
    const auto rows = selectedRows(1);
    if (rows.empty())
        return;
    MessageFilter filter = bar_->filter();
    if (only)
        filter.types = {.types = {rows.front()->type}, .only_these = true};
    else if (filter.types.only_these)
        filter.types.types.erase(rows.front()->type);
    else
        filter.types.types.insert(rows.front()->type);
    setFilter(filter);
}

} // namespace usar::widgets
