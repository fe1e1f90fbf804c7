// The message inspector's part of MainWindow: its commands, what it sends, and what it remembers.
#include <QFileDialog>
#include <QFileInfo>
#include <QSettings>

#include "app/main_window.h"

namespace usar::app {

void MainWindow::registerMessageCommands() {
    const widgets::MessageActions& a = views_.messages->actions();
    const QString group = tr("Messages");
    const auto adopt = [&](const char* id, QAction* action, const QKeySequence& keys = {}) {
        commands_.adopt({QString("messages.") + id, action->text(), group, action->toolTip(), "",
                         keys.isEmpty() ? QList<QKeySequence>() : QList<QKeySequence>{keys}},
                        action);
    };
    commands_.add({"messages.find",
                   tr("Search messages"),
                   group,
                   tr("Type, text or reason of a line"),
                   "search",
                   {QKeySequence::Find}},
                  [this](bool) {
                      showMessages();
                      views_.messages->focusSearch();
                  });
    commands_.add({"messages.command",
                   tr("Type a raw command"),
                   group,
                   tr("Any line to the selected robot, with completion and history"),
                   "",
                   {QKeySequence("F4")}},
                  [this](bool) {
                      showMessages();
                      views_.command_box->line()->setFocus(Qt::ShortcutFocusReason);
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
    commands_.add({"link.figures",
                   tr("Link figures"),
                   tr("Server"),
                   tr("Lines, bytes, unknown, malformed and dropped lines of the connection"),
                   "",
                   {QKeySequence("F9")}},
                  [this](bool) { views_.connection->openPanel(); });
}

void MainWindow::showMessages() {
    auto* dock = findChild<QDockWidget*>("messages");
    dock->show();
    dock->raise();
}

void MainWindow::wireMessages() {
    auto* messages = views_.messages;
    connect(messages, &widgets::MessageList::countChanged, views_.message_count, &QLabel::setText);
    connect(messages, &widgets::MessageList::failed, this,
            [this](const QString& reason) { say(Severity::Warning, "messages", reason); });
    connect(messages, &widgets::MessageList::saved, this, [this](const QString& path, int lines) {
        views_.notifications->cured("messages");
        views_.notifications->push("messages-saved", Severity::Note, tr("Saved %n line(s): %1", "", lines).arg(path),
                                   true);
    });
    connect(messages, &widgets::MessageList::saveRequested, this, [this] {
        QString kind;
        const QString path = QFileDialog::getSaveFileName(this, tr("Save messages"), tr("messages"),
                                                          tr("Text (*.txt);;JSON lines (*.jsonl)"), &kind);
        if (path.isEmpty())
            return;
        const QString suffix = kind.contains(QStringLiteral("jsonl")) ? ".jsonl" : ".txt";
        views_.messages->saveShown(QFileInfo(path).suffix().isEmpty() ? path + suffix : path);
    });
    connect(messages, &widgets::MessageList::resendRequested, this, [this](int connection, const QStringList& lines) {
        for (const QString& line : lines)
            if (const auto sent = control_.sendLine(connection, line, "operator: resend"); !sent)
                return complain("resend", sent.error());
        control_.cure("resend");
    });
    connect(views_.command_box, &widgets::CommandBox::sendRequested, this, [this](const QString& line) {
        const int connection = control_.connectionOf(selected_);
        if (const auto sent = control_.sendLine(connection, line, "operator: command box"); !sent)
            views_.command_box->complain(Severity::Error, QString::fromStdString(sent.error().text()));
    });
    connect(views_.traffic, &QToolButton::clicked, views_.connection, &widgets::ConnectionBar::openPanel);
}

void MainWindow::followConnection() {
    const int connection = control_.connectionOf(selected_);
    const Robot* robot = control_.robot(selected_);
    const QString name = robot ? QString::fromStdString(robot->view().spawn.robot_name) : QString();
    views_.messages->nameConnection(connection, name.isEmpty() ? tr("link") : name);
    views_.messages->selectConnection(connection);
    const auto sendable = control_.checkLine(connection);
    views_.command_box->setTarget(!sendable        ? QString()
                                  : name.isEmpty() ? tr("the server")
                                                   : name,
                                  sendable ? QString() : QString::fromStdString(sendable.error().text()));
    views_.connection->panel()->setName(name);
}

void MainWindow::restoreMessages() {
    const QSettings settings;
    views_.command_box->setHistory(settings.value("messages/history").toStringList());
    views_.messages->actions().details->setChecked(settings.value("messages/details").toBool());
    views_.messages->actions().all_robots->setChecked(settings.value("messages/all_robots").toBool());
}

void MainWindow::saveMessages(QSettings& settings) const {
    settings.setValue("messages/history", views_.command_box->history());
    settings.setValue("messages/details", views_.messages->actions().details->isChecked());
    settings.setValue("messages/all_robots", views_.messages->actions().all_robots->isChecked());
}

} // namespace usar::app
