// The cheat sheet (F1): every command that has a shortcut, by group, made from the registry.
#pragma once

#include <QDialog>

#include "widgets/command_registry.h"

namespace usar::widgets {

/// Not modal; Escape closes it. `gestures` are lines for what the mouse does ("Double-click a start pose", "spawn a
/// robot there"), shown under their own heading.
class ShortcutSheet : public QDialog {
    Q_OBJECT
public:
    ShortcutSheet(const CommandRegistry& registry, const QList<std::pair<QString, QString>>& gestures, QWidget* window);
};

} // namespace usar::widgets
