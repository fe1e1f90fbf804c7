// The command palette (Ctrl+K): type a few letters of any command and press Return.
#pragma once

#include <QFrame>
#include <QLineEdit>
#include <QListView>

#include "widgets/commands/command_list_model.h"

namespace usar::widgets {

/// A popup over its window, not a dialog: Escape or a click elsewhere closes it. Up and Down choose while the text
/// cursor stays in the line. GUI thread; owned by the window.
class CommandPalette : public QFrame {
    Q_OBJECT
public:
    /// The registry must outlive the palette. The palette is centered over the window, which owns it.
    CommandPalette(const CommandRegistry& registry, QWidget* window);

public slots:
    /// Clears the line, lists the commands that are enabled now, and takes the focus.
    void open();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    /// Moves the marked row by `by`, stopping at the ends of the list.
    void choose(int by);
    /// Closes the palette and then triggers the marked command, so that the command may open something itself.
    void run();

    CommandListModel* model_;
    QLineEdit* line_;
    QListView* list_;
};

} // namespace usar::widgets
