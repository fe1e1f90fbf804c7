#include "widgets/plan/editor/plan_actions.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

#include "widgets/style/icons.h"

namespace usar::widgets {

namespace {

constexpr const char* in_drawing_property = "in_drawing";

} // namespace

bool isKeyOfDrawing(const QKeyEvent& event) {
    if (event.modifiers() & Qt::ControlModifier)
        return event.key() >= Qt::Key_Left && event.key() <= Qt::Key_Down;
    constexpr std::array keys{Qt::Key_F,    Qt::Key_N,     Qt::Key_Space, Qt::Key_Home,   Qt::Key_End,
                              Qt::Key_Plus, Qt::Key_Equal, Qt::Key_Minus, Qt::Key_Return, Qt::Key_Enter};
    return std::ranges::find(keys, event.key()) != keys.end();
}

QAction* PlanActions::add(const PlanCommand& command, std::function<void()> run) {
    auto* made = new QAction(command.text, &owner_);
    const QString keys = command.keys.toString(QKeySequence::NativeText);
    made->setToolTip(keys.isEmpty() ? command.help : command.help + QStringLiteral(" (") + keys + u')');
    if (command.icon[0] != '\0')
        made->setIcon(icon(QString::fromLatin1(command.icon)));
    made->setShortcut(command.keys);
    made->setShortcutContext(Qt::WidgetShortcut);
    made->setProperty(in_drawing_property, command.in_drawing);
    QObject::connect(made, &QAction::triggered, &owner_, std::move(run));
    actions_.emplace(QString::fromLatin1(command.name), made);
    return made;
}

QAction* PlanActions::action(const QString& name) const {
    const auto found = actions_.find(name);
    assert(found != actions_.end());
    return found->second;
}

void PlanActions::enable(std::initializer_list<const char*> names, bool on) {
    for (const char* const name : names)
        enable(name, on);
}

void PlanActions::fill(QMenu& menu, std::initializer_list<const char*> names) const {
    for (const char* const name : names)
        menu.addAction(action(QString::fromLatin1(name)));
}

QAction* PlanActions::actionOf(const QKeyEvent& event, bool in_drawing) const {
    const QKeySequence keys(QKeyCombination(event.modifiers() & ~Qt::KeypadModifier, Qt::Key(event.key())));
    for (const auto& [name, candidate] : actions_)
        if (candidate->shortcut() == keys && (in_drawing || !candidate->property(in_drawing_property).toBool()))
            return candidate;
    return nullptr;
}

} // namespace usar::widgets
