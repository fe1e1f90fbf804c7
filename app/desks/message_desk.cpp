#include "app/desks/message_desk.h"

#include "widgets/panels/dialogs.h"

namespace usar::app {

void MessageDesk::registerCommands() {
    add("messages.find", [this] {
        raise(views_.messages_dock);
        views_.messages->focusSearch();
    });
    add("messages.command", [this] {
        raise(views_.messages_dock);
        views_.command_box->line()->setFocus(Qt::ShortcutFocusReason);
    });
    widgets::adoptMessageActions(commands_, views_.messages->actions());
    add("link.figures", [this] { views_.connection->openPanel(); });
}

void MessageDesk::wire() {
    auto* const messages = views_.messages;
    connect(messages, &widgets::MessageList::failed, this,
            [this](const QString& reason) { notices_.say(Severity::Warning, "messages", reason); });
    connect(messages, &widgets::MessageList::saved, this, [this](const QString& path, int lines) {
        notices_.cure("messages");
        notices_.note("messages-saved", tr("Saved %n line(s): %1", "", lines).arg(path));
    });
    connect(messages, &widgets::MessageList::saveRequested, this, &MessageDesk::chooseWhereToSave);
    connect(messages, &widgets::MessageList::resendRequested, this, &MessageDesk::sendAgain);
    connect(views_.command_box, &widgets::CommandBox::sendRequested, this, &MessageDesk::sendTyped);
    connect(&control_, &MissionControl::linkChanged, this, &MessageDesk::followConnection);
    connect(&control_, &MissionControl::robotLinkChanged, this, &MessageDesk::followConnection);
    connect(&selection_, &Selection::changed, this, &MessageDesk::followConnection);
}

void MessageDesk::chooseWhereToSave() {
    widgets::askWhereToSave(window_, tr("Save messages"), tr("messages"), tr("Text (*.txt);;JSON lines (*.jsonl)"),
                            [this](const QString& path) { views_.messages->saveShown(path); });
}

void MessageDesk::sendAgain(ConnectionId connection, const QStringList& lines) {
    for (const QString& line : lines)
        if (const auto sent = control_.sendLine(connection, line, by::Operator{"resend"}); !sent)
            return notices_.complain("resend", sent.error());
    notices_.cure("resend");
}

void MessageDesk::sendTyped(const QString& line) {
    const ConnectionId connection = control_.connectionOf(selection_.id());
    if (const auto sent = control_.sendLine(connection, line, by::Operator{"command box"}); !sent)
        views_.command_box->complain(Severity::Error, QString::fromStdString(sent.error().text()));
    else
        control_.history().note(line);
}

void MessageDesk::followConnection() {
    const ConnectionId connection = control_.connectionOf(selection_.id());
    const QString name = robot() ? nameOf(*robot()) : QString();
    views_.messages->nameConnection(connection, name.isEmpty() ? tr("link") : name);
    views_.messages->selectConnection(connection);
    const auto sendable = control_.checkLine(connection);
    views_.command_box->setTarget(!sendable        ? QString()
                                  : name.isEmpty() ? tr("the server")
                                                   : name,
                                  sendable ? QString() : QString::fromStdString(sendable.error().text()));
    views_.connection->panel()->setName(name);
}

void MessageDesk::restore(const QSettings& settings) {
    views_.command_box->setHistory(settings.value("messages/history").toStringList());
    views_.messages->actions().details->setChecked(settings.value("messages/details").toBool());
    views_.messages->actions().all_robots->setChecked(settings.value("messages/all_robots").toBool());
}

void MessageDesk::save(SettingsSheet& settings) const {
    settings.setValue("messages/history", views_.command_box->history());
    settings.setValue("messages/details", views_.messages->actions().details->isChecked());
    settings.setValue("messages/all_robots", views_.messages->actions().all_robots->isChecked());
}

} // namespace usar::app
