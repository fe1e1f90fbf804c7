// The keys that the user has given to commands: as a file, and what may be given.
#pragma once

#include "core/base/result.h"
#include "widgets/commands/command_registry.h"

namespace usar::widgets {

/// The file that keeps the keys, as JSON: {"format": …, "version": 1, "keys": {"map.fit": ["F"]}}. An empty list takes
/// all keys from a command.
QByteArray keysText(const KeyChoices& keys);
/// Reads such a text; `file` is named in errors. Refuses a text of a newer version of the program, and keys that do not
/// exist; commands that do not exist are left out by the registry.
Result<KeyChoices> readKeys(const QByteArray& text, const QString& file);

/// What it would mean to give a key to a command.
struct KeyVerdict {
    bool possible = true;
    QString owner; ///< id of the command that has the key now; empty: it is free
    QString words; ///< a sentence for the user if the key is not free or not possible
};

/// Escape belongs to the stop of all robots, and Tab and Return lead through the window.
KeyVerdict judgeKey(const CommandRegistry& registry, const QString& id, const QKeySequence& key);
/// Gives the command this one key, and takes it from its owner. An empty key leaves the command without one.
void giveKey(CommandRegistry& registry, const QString& id, const QKeySequence& key);

} // namespace usar::widgets
