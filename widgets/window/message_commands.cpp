#include "widgets/window/message_commands.h"

namespace usar::widgets {

void adoptMessageActions(CommandRegistry& commands, const MessageActions& actions) {
    const auto adopt = [&](const QString& id, QAction* action, const QList<QKeySequence>& keys = {}) {
        commands.adopt({"messages." + id, action->text(), QObject::tr("Messages"), action->toolTip(), "", keys},
                       action);
    };
    adopt("pause", actions.pause, {QKeySequence("F8")});
    adopt("follow", actions.follow, {QKeySequence("Ctrl+Shift+End")});
    adopt("details", actions.details, {QKeySequence("Ctrl+I")});
    adopt("cause", actions.cause, {QKeySequence("Ctrl+J")});
    adopt("resend", actions.resend, {QKeySequence("Ctrl+Shift+R")});
    adopt("only_trouble", actions.only_trouble, {QKeySequence("Ctrl+Shift+F")});
    adopt("only_type", actions.only_type);
    adopt("hide_type", actions.hide_type);
    adopt("no_filter", actions.no_filter, {QKeySequence("Ctrl+Shift+A")});
    adopt("all_robots", actions.all_robots);
    adopt("copy", actions.copy, {QKeySequence::Copy});
    adopt("copy_text", actions.copy_text, {QKeySequence("Ctrl+Shift+C")});
    adopt("copy_json", actions.copy_json);
    adopt("copy_shown", actions.copy_shown);
    adopt("save", actions.save);
    adopt("clear", actions.clear);
}

} // namespace usar::widgets
