#include "widgets/commands/command_registry.h"

#include <algorithm>
#include <iterator>

#include <QEvent>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QMetaEnum>
#include <QScopedValueRollback>

#include "widgets/style/icons.h"

namespace usar::widgets {

namespace {

/// An action that knows whether a key triggers it at the moment.
class KeyedAction : public QAction {
public:
    using QAction::QAction;
    bool byKey() const { return by_key_; }

protected:
    bool event(QEvent* event) override {
        const QScopedValueRollback by_key(by_key_, event->type() == QEvent::Shortcut);
        return QAction::event(event);
    }

private:
    bool by_key_ = false;
};

/// True for keys that people type: without Ctrl, Alt or Meta, and no function key.
bool isPlain(const QKeySequence& keys) {
    if (keys.count() != 1 || (keys[0].keyboardModifiers() & ~Qt::KeyboardModifiers(Qt::ShiftModifier)))
        return false;
    return keys[0].key() < Qt::Key_F1 || keys[0].key() > Qt::Key_F35;
}

} // namespace

CommandRegistry::CommandRegistry(QWidget* window) : QObject(window), window_(window) {}

QAction* CommandRegistry::add(const CommandSpec& spec, std::function<void(bool)> run, std::function<bool()> enabled) {
    auto* action = new KeyedAction(icon(spec.icon), spec.text, this);
    action->setCheckable(spec.checkable);
    if (!spec.button.isEmpty())
        action->setIconText(spec.button);
    if (run)
        connect(action, &QAction::triggered, this, [this, action, spec, call = std::move(run)](bool on) {
            const auto obey = [this, spec, call](bool checked) {
                call(checked);
                if (spec.sends)
                    emit sent(spec);
            };
            const bool asks = action->byKey() && !spec.question.isEmpty() && !(spec.checkable && on);
            if (!asks)
                return obey(on);
            action->setChecked(!on); // It stays as it was until the answer.
            emit questionRaised(spec, [obey, on] { obey(on); });
        });
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
    action->setWhatsThis(tooltipText(spec));
    window_->addAction(action);
    commands_.push_back(std::make_unique<Command>(Command{spec, action, std::move(enabled), spec.shortcuts}));
    if (const auto& rule = commands_.back()->enabled)
        action->setEnabled(rule());
}

CommandRegistry::Command* CommandRegistry::find(const QString& id) const {
    const auto found = std::ranges::find_if(commands_, [&](const auto& command) { return command->spec.id == id; });
    return found == commands_.end() ? nullptr : found->get();
}

QAction* CommandRegistry::action(const QString& id) const {
    const Command* command = find(id);
    Q_ASSERT_X(command, "CommandRegistry::action", qPrintable(id));
    return command->action;
}

void CommandRegistry::setPlacesOfPlainKeys(const QList<QWidget*>& places) {
    places_ = places;
    for (const auto& command : commands_)
        if (std::ranges::any_of(command->spec.shortcuts, isPlain))
            place(*command);
}

void CommandRegistry::place(const Command& command) {
    if (places_.isEmpty())
        return;
    const bool plain = std::ranges::any_of(command.spec.shortcuts, isPlain);
    command.action->setShortcutContext(plain ? Qt::WidgetWithChildrenShortcut : Qt::WindowShortcut);
    for (QWidget* const widget : places_)
        plain ? widget->addAction(command.action) : widget->removeAction(command.action);
    plain ? window_->removeAction(command.action) : window_->addAction(command.action);
}

const CommandRegistry::Command* CommandRegistry::ownerOf(const QKeySequence& key) const {
    const auto has = [&](const auto& command) { return command->spec.shortcuts.contains(key); };
    const auto found = std::ranges::find_if(commands_, has);
    return found == commands_.end() ? nullptr : found->get();
}

void CommandRegistry::give(Command& command, const QList<QKeySequence>& keys) {
    const bool was_plain = std::ranges::any_of(command.spec.shortcuts, isPlain);
    command.spec.shortcuts = keys;
    command.action->setShortcuts(keys);
    command.action->setToolTip(tooltipText(command.spec));
    if (was_plain != std::ranges::any_of(keys, isPlain))
        place(command);
}

void CommandRegistry::setKeys(const QString& id, const QList<QKeySequence>& keys) {
    Command* const command = find(id);
    Q_ASSERT_X(command, "CommandRegistry::setKeys", qPrintable(id));
    for ([[maybe_unused]] const QKeySequence& key : keys)
        Q_ASSERT_X(!ownerOf(key) || ownerOf(key) == command, "CommandRegistry::setKeys", "the key is taken");
    give(*command, keys);
    emit keysChanged();
}

void CommandRegistry::takeKeys(const KeyChoices& keys) {
    for (const auto& command : commands_)
        give(*command, keys.contains(command->spec.id) ? QList<QKeySequence>() : command->first_keys);
    for (const auto& [id, wanted] : keys) {
        QList<QKeySequence> free = wanted;
        free.removeIf([this](const QKeySequence& key) { return ownerOf(key) != nullptr; });
        if (Command* const command = find(id))
            give(*command, free);
    }
    emit keysChanged();
}

KeyChoices CommandRegistry::changedKeys() const {
    KeyChoices changed;
    for (const auto& command : commands_)
        if (command->spec.shortcuts != command->first_keys)
            changed[command->spec.id] = command->spec.shortcuts;
    return changed;
}

void CommandRegistry::refresh() {
    for (const auto& command : commands_)
        if (command->enabled)
            command->action->setEnabled(command->enabled());
}

std::vector<PaletteOffer> CommandRegistry::offers() const {
    std::vector<PaletteOffer> all;
    for (const auto& provider : providers_)
        std::ranges::move(provider(), std::back_inserter(all));
    return all;
}

void CommandRegistry::fill(QMenu* menu, const QStringList& ids) const {
    menu->setToolTipsVisible(true);
    for (const QString& id : ids)
        if (id == u"-")
            menu->addSeparator();
        else if (!id.endsWith(u'*'))
            menu->addAction(action(id));
        else
            for (const auto& command : commands_)
                if (command->spec.id.startsWith(QStringView(id).chopped(1)))
                    menu->addAction(command->action);
}

QString tooltipText(const CommandSpec& spec) {
    QString text = spec.help.isEmpty() ? spec.text : spec.help;
    if (!spec.shortcuts.isEmpty())
        text += QStringLiteral(" (%1)").arg(spec.shortcuts.front().toString(QKeySequence::NativeText));
    return text;
}

extern const char commands_json[];
extern const char menus_json[];

namespace {

QKeySequence keysOf(const QString& text) {
    const QString prefix = "StandardKey::";
    if (!text.startsWith(prefix))
        return QKeySequence(text, QKeySequence::PortableText);
    const auto standard = QMetaEnum::fromType<QKeySequence::StandardKey>();
    return static_cast<QKeySequence::StandardKey>(standard.keyToValue(text.mid(prefix.size()).toLatin1().constData()));
}

CommandSpec specOf(const QString& id, const QString& group, const QJsonObject& row) {
    CommandSpec spec{id, row["text"].toString(), group, row["help"].toString(), row["icon"].toString(), {}};
    for (const auto& keys : row["keys"].toArray())
        spec.shortcuts << keysOf(keys.toString());
    spec.button = row["button"].toString();
    spec.checkable = row["checkable"].toBool();
    spec.twice = keysOf(row["twice"].toString());
    if (!spec.twice.isEmpty())
        spec.help = spec.help.arg(spec.twice.toString(QKeySequence::NativeText));
    spec.question = row["question"].toString();
    spec.answer = row["answer"].toString();
    spec.sends = row["sends"].toBool();
    spec.words = row["words"].toString().split(", ", Qt::SkipEmptyParts);
    return spec;
}

/// Appends a menu's items; lists its submenus by their names.
void fillMenu(QMenu* menu, const QJsonArray& items, const CommandRegistry& commands,
              std::map<QString, QMenu*>& submenus) {
    for (const QJsonValue& item : items) {
        if (item.isString()) {
            commands.fill(menu, item.toString().split(u' '));
            continue;
        }
        QMenu* const submenu = submenus[item["submenu"].toString()] = menu->addMenu(item["title"].toString());
        fillMenu(submenu, item["items"].toArray(), commands, submenus);
    }
}

} // namespace

std::vector<CommandSpec> readCommandTable(const QByteArray& json) {
    std::vector<CommandSpec> table;
    const QJsonObject groups = QJsonDocument::fromJson(json).object();
    for (auto group = groups.begin(); group != groups.end(); ++group) {
        const QJsonObject rows = group->toObject();
        for (auto row = rows.begin(); row != rows.end(); ++row)
            table.push_back(specOf(row.key(), group.key(), row->toObject()));
    }
    return table;
}

const std::vector<CommandSpec>& commandTable() {
    static const std::vector<CommandSpec> table = readCommandTable(commands_json);
    return table;
}

const CommandSpec& commandSpec(const QString& id) {
    const auto found = std::ranges::find(commandTable(), id, &CommandSpec::id);
    Q_ASSERT_X(found != commandTable().end(), "commandSpec", qPrintable(id));
    return *found;
}

std::map<QString, QMenu*> makeMenus(QMenuBar& bar, const CommandRegistry& commands) {
    std::map<QString, QMenu*> submenus;
    for (const QJsonValue& row : QJsonDocument::fromJson(menus_json).array()) {
        QMenu* const menu = bar.addMenu(row["title"].toString());
        fillMenu(menu, row["items"].toArray(), commands, submenus);
    }
    return submenus;
}

} // namespace usar::widgets
