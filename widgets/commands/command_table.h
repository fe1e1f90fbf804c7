// The words, icons and keys of the program's commands, which stand in resources/commands.json.
#pragma once

#include "widgets/commands/command_registry.h"

namespace usar::widgets {

/// Reads a table of commands: an object of groups, each an object of commands by id, with `text`, `help`, and possibly
/// `icon`, `keys` and `checkable`. A key is written as in a menu ("Ctrl+K"), or names one that differs by desktop
/// ("StandardKey::Open"). Text that is no JSON object is read as an empty table.
std::vector<CommandSpec> readCommandTable(const QByteArray& json);

/// All commands of the program's own table, sorted by group and id.
const std::vector<CommandSpec>& commandTable();
/// The command with this id; an unknown id is a programming error (assertion).
const CommandSpec& commandSpec(const QString& id);

} // namespace usar::widgets
