// The shortcut overview (F1): every command that has a shortcut, by group, generated from the registry.
#pragma once

#include <QDialog>

#include "widgets/commands/command_registry.h"

namespace usar::widgets {

/// Not modal; Escape closes it. `gestures` are pairs of a mouse action and its effect ("Double-click a start pose",
/// "spawn a robot there"), listed under a heading of their own.
class ShortcutSheet : public QDialog {
    Q_OBJECT
public:
    ShortcutSheet(const CommandRegistry& registry, const QList<std::pair<QString, QString>>& gestures, QWidget* window);
};

} // namespace usar::widgets
