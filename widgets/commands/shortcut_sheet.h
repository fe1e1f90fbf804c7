// The shortcut overview (F1): every command that has a shortcut, by group, generated from the registry, and what can be
// done with mouse and held keys.
#pragma once

#include <utility>

#include <QDialog>
#include <QList>
#include <QString>

#include "widgets/commands/command_registry.h"

namespace usar::widgets {

/// Pairs of a gesture and what it does.
QList<std::pair<QString, QString>> gestures();

/// Not modal; Escape closes it. `gestures` are pairs of a mouse action and its effect ("Double-click a start pose",
/// "spawn a robot there"), listed under a heading of their own.
class ShortcutSheet : public QDialog {
    Q_OBJECT
public:
    ShortcutSheet(const CommandRegistry& registry, const QList<std::pair<QString, QString>>& gestures, QWidget* window);
};

} // namespace usar::widgets
