// The lines and commands of an update in the order in which they crossed the wire.
#pragma once

#include "core/mission/session/session_update.h"

namespace usar::mission {

/// Calls `take_line` with each line and `take_command` with each command. A command follows the last line that had come
/// when it was sent, by its `after`; lines that were left out of the update do not change the order of the others.
template <class TakeLine, class TakeCommand>
void inOrder(const SessionUpdate& update, TakeLine take_line, TakeCommand take_command) {
    auto command = update.commands.begin();
    for (const protocol::InfoLine& line : update.lines) {
        for (; command != update.commands.end() && command->after < line.number; ++command)
            take_command(*command);
        take_line(line);
    }
    for (; command != update.commands.end(); ++command)
        take_command(*command);
}

} // namespace usar::mission
