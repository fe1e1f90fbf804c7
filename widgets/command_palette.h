// The command palette (Ctrl+K): type a few letters of any command, press Return.
#pragma once

#include <QFrame>
#include <QLineEdit>
#include <QListView>

#include "widgets/models/command_list_model.h"

namespace usar::widgets {

/// A sheet over its window, not a dialog: Escape or a click elsewhere closes it. Up and Down choose while the cursor
/// stays in the line. GUI thread; owned by the window.
class CommandPalette : public QFrame {
    Q_OBJECT
public:
    /// The registry outlives the palette; the window is what it centers over.
    CommandPalette(const CommandRegistry& registry, QWidget* window);

public slots:
    /// Empties the line, lists what is possible now, and takes the focus.
    void open();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    /// Moves the choice without leaving the ends.
    void choose(int by);
    /// Closes first, so that a command may open something itself.
    void run();

    CommandListModel* model_;
    QLineEdit* line_;
    QListView* list_;
};

} // namespace usar::widgets
