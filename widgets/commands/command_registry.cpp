#include "widgets/commands/command_registry.h"

#include <algorithm>

#include "widgets/style/icons.h"

namespace usar::widgets {

CommandRegistry::CommandRegistry(QWidget* window) : QObject(window), window_(window) {}

CommandRegistry::~CommandRegistry() = default;

QAction* CommandRegistry::add(const CommandSpec& spec, std::function<void(bool)> run, std::function<bool()> enabled) {
    auto* action = new QAction(icon(spec.icon), spec.text, this);
    action->setCheckable(spec.checkable);
    if (run)
        connect(action, &QAction::triggered, this, std::move(run));
    list(spec, action, std::move(enabled));
    return action;
}

void CommandRegistry::adopt(const CommandSpec& spec, QAction* action) {
    action->setText(spec.text);
    list(spec, action, {});
}

void CommandRegistry::list(const CommandSpec& spec, QAction* action, std::function<bool()> enabled) {
    Q_ASSERT_X(!contains(spec.id), "CommandRegistry::list", "the id is taken");
    for ([[maybe_unused]] const auto& other : commands_)
        for ([[maybe_unused]] const QKeySequence& keys : spec.shortcuts)
            Q_ASSERT_X(!other->spec.shortcuts.contains(keys), "CommandRegistry::list", "the shortcut is taken");
    action->setObjectName(spec.id);
    action->setShortcuts(spec.shortcuts);
    action->setToolTip(tooltipText(spec));
    action->setStatusTip(spec.help);
    window_->addAction(action);
    commands_.push_back(std::make_unique<Command>(Command{spec, action, std::move(enabled)}));
    if (const auto& rule = commands_.back()->enabled)
        action->setEnabled(rule());
}

const CommandRegistry::Command* CommandRegistry::find(const QString& id) const {
    const auto found = std::ranges::find_if(commands_, [&](const auto& command) { return command->spec.id == id; });
    return found == commands_.end() ? nullptr : found->get();
}

QAction* CommandRegistry::action(const QString& id) const {
    const Command* command = find(id);
    Q_ASSERT_X(command, "CommandRegistry::action", qPrintable(id));
    return command->action;
}

bool CommandRegistry::contains(const QString& id) const {
    return find(id) != nullptr;
}

void CommandRegistry::refresh() {
    for (const auto& command : commands_)
        if (command->enabled)
            command->action->setEnabled(command->enabled());
}

void CommandRegistry::fill(QMenu* menu, const QStringList& ids) const {
    menu->setToolTipsVisible(true);
    for (const QString& id : ids)
        id == u"-" ? menu->addSeparator() : (menu->addAction(action(id)), nullptr);
}

void CommandRegistry::fill(QToolBar* bar, const QStringList& ids) const {
    for (const QString& id : ids)
        id == u"-" ? bar->addSeparator() : (bar->addAction(action(id)), nullptr);
}

QString tooltipText(const CommandSpec& spec) {
    QString text = spec.help.isEmpty() ? spec.text : spec.help;
    if (!spec.shortcuts.isEmpty())
        text += QStringLiteral(" (%1)").arg(spec.shortcuts.front().toString(QKeySequence::NativeText));
    return text;
}

} // namespace usar::widgets
