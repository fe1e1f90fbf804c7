#include "widgets/window/window_help.h"

#include <QWhatsThis>

#include "widgets/commands/help.h"
#include "widgets/commands/shortcut_sheet.h"

namespace usar::widgets {

namespace {

/// Shows the dialog; makes it first if it is closed.
void showOne(QPointer<QDialog>& dialog, const auto& make) {
    if (!dialog) {
        dialog = make();
        dialog->setAttribute(Qt::WA_DeleteOnClose);
    }
    dialog->show();
    dialog->raise();
    dialog->activateWindow();
}

} // namespace

WindowHelp::WindowHelp(QMainWindow& window, const WindowViews& views, CommandRegistry& commands)
    : window_(window)
    , commands_(commands)
    , tour_(window, views) {}

void WindowHelp::registerCommands() {
    const auto add = [this](const char* id, const auto& run) {
        commands_.add(commandSpec(id), [run](bool) { run(); });
    };
    add("help.shortcuts", [this] { showOne(sheet_, [this] { return makeShortcutSheet(commands_, &window_); }); });
    add("help.what", [this] {
        explainParts(window_);
        QWhatsThis::enterWhatsThisMode();
    });
    add("help.tour", [this] { tour_.begin(); });
    add("help.about", [this] { showOne(about_, [this] { return makeAbout(&window_); }); });
}

} // namespace usar::widgets
