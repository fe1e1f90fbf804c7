#include "app/desks/message_desk.h"

#include <QFileDialog>
#include <QFileInfo>

namespace usar::app {

void MessageDesk::registerCommands() {
    const widgets::MessageActions& a = desk_.views.messages->actions();
    const QString group = tr("Messages");
    const auto adopt = [&](const char* id, QAction* action, const QKeySequence& keys = {}) {
        desk_.commands.adopt({QString("messages.") + id, action->text(), group, action->toolTip(), "",
                              keys.isEmpty() ? QList<QKeySequence>() : QList<QKeySequence>{keys}},
                             action);
    };
    desk_.commands.add({"messages.find",
                        tr("Search messages"),
                        group,
                        tr("Type, text or reason of a line"),
                        "search",
                        {QKeySequence::Find}},
                       [this](bool) {
                           raiseDock();
                           desk_.views.messages->focusSearch();
                       });
    desk_.commands.add({"messages.command",
                        tr("Type a raw command"),
                        group,
                        tr("Any line to the selected robot, with completion and history"),
                        "",
                        {QKeySequence("F4")}},
                       [this](bool) {
                           raiseDock();
                           desk_.views.command_box->line()->setFocus(Qt::ShortcutFocusReason);
                       });
    adopt("pause", a.pause, QKeySequence("F8"));
    adopt("follow", a.follow, QKeySequence("Ctrl+Shift+End"));
    adopt("details", a.details, QKeySequence("Ctrl+I"));
    adopt("cause", a.cause, QKeySequence("Ctrl+J"));
    adopt("resend", a.resend, QKeySequence("Ctrl+Shift+R"));
    adopt("only_trouble", a.only_trouble, QKeySequence("Ctrl+Shift+F"));
    adopt("only_type", a.only_type);
    adopt("hide_type", a.hide_type);
    adopt("no_filter", a.no_filter, QKeySequence("Ctrl+Shift+A"));
    adopt("all_robots", a.all_robots);
    adopt("copy", a.copy, QKeySequence::Copy);
    adopt("copy_text", a.copy_text, QKeySequence("Ctrl+Shift+C"));
    adopt("copy_json", a.copy_json);
    adopt("copy_shown", a.copy_shown);
    adopt("save", a.save);
    adopt("clear", a.clear);
    desk_.commands.add({"link.figures",
                        tr("Link figures"),
                        tr("Server"),
                        tr("Lines, bytes, unknown, malformed and dropped lines of the connection"),
                        "",
                        {QKeySequence("F9")}},
                       [this](bool) { desk_.views.connection->openPanel(); });
}

void MessageDesk::raiseDock() {
    desk_.views.messages_dock->show();
    desk_.views.messages_dock->raise();
}

void MessageDesk::wire() {
    wireList();
    connect(desk_.views.command_box, &widgets::CommandBox::sendRequested, this, &MessageDesk::sendTyped);
    connect(desk_.views.traffic, &QToolButton::clicked, desk_.views.connection, &widgets::ConnectionBar::openPanel);
    connect(&desk_.control, &MissionControl::linkChanged, this, &MessageDesk::followConnection);
    connect(&desk_.control, &MissionControl::robotLinkChanged, this, &MessageDesk::followConnection);
    connect(&desk_.selection, &Selection::changed, this, &MessageDesk::followConnection);
}

void MessageDesk::wireList() {
    auto* const messages = desk_.views.messages;
    connect(messages, &widgets::MessageList::countChanged, desk_.views.message_count, &QLabel::setText);
    connect(messages, &widgets::MessageList::failed, this,
            [this](const QString& reason) { desk_.notices.say(Severity::Warning, "messages", reason); });
    connect(messages, &widgets::MessageList::saved, this, [this](const QString& path, int lines) {
        desk_.notices.cure("messages");
        desk_.notices.note("messages-saved", tr("Saved %n line(s): %1", "", lines).arg(path));
    });
    connect(messages, &widgets::MessageList::saveRequested, this, &MessageDesk::chooseWhereToSave);
    connect(messages, &widgets::MessageList::resendRequested, this, &MessageDesk::sendAgain);
}

void MessageDesk::chooseWhereToSave() {
    QString kind;
    const QString path = QFileDialog::getSaveFileName(desk_.window, tr("Save messages"), tr("messages"),
                                                      tr("Text (*.txt);;JSON lines (*.jsonl)"), &kind);
    if (path.isEmpty())
        return;
    const QString suffix = kind.contains(QStringLiteral("jsonl")) ? ".jsonl" : ".txt";
    desk_.views.messages->saveShown(QFileInfo(path).suffix().isEmpty() ? path + suffix : path);
}

void MessageDesk::sendAgain(int connection, const QStringList& lines) {
    for (const QString& line : lines)
        if (const auto sent = desk_.control.sendLine(connection, line, "operator: resend"); !sent)
            return desk_.notices.complain("resend", sent.error());
    desk_.notices.cure("resend");
}

void MessageDesk::sendTyped(const QString& line) {
    const int connection = desk_.control.connectionOf(desk_.selection.id());
    if (const auto sent = desk_.control.sendLine(connection, line, "operator: command box"); !sent)
        desk_.views.command_box->complain(Severity::Error, QString::fromStdString(sent.error().text()));
}

void MessageDesk::followConnection() {
    const int connection = desk_.control.connectionOf(desk_.selection.id());
    const Robot* robot = desk_.selection.robot();
    const QString name = robot ? QString::fromStdString(robot->view().spawn.robot_name) : QString();
    desk_.views.messages->nameConnection(connection, name.isEmpty() ? tr("link") : name);
    desk_.views.messages->selectConnection(connection);
    const auto sendable = desk_.control.checkLine(connection);
    desk_.views.command_box->setTarget(!sendable        ? QString()
                                       : name.isEmpty() ? tr("the server")
                                                        : name,
                                       sendable ? QString() : QString::fromStdString(sendable.error().text()));
    desk_.views.connection->panel()->setName(name);
}

void MessageDesk::restore(const QSettings& settings) {
    desk_.views.command_box->setHistory(settings.value("messages/history").toStringList());
    desk_.views.messages->actions().details->setChecked(settings.value("messages/details").toBool());
    desk_.views.messages->actions().all_robots->setChecked(settings.value("messages/all_robots").toBool());
}

void MessageDesk::save(QSettings& settings) const {
    settings.setValue("messages/history", desk_.views.command_box->history());
    settings.setValue("messages/details", desk_.views.messages->actions().details->isChecked());
    settings.setValue("messages/all_robots", desk_.views.messages->actions().all_robots->isChecked());
}

} // namespace usar::app
