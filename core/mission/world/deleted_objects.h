// The objects that the user has deleted from the world, with undo and redo.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <QUndoStack>

#include "core/protocol/command.h"

namespace usar::mission {

/// Undo and redo of deletions. Runs in the thread of its owner, which sends the commands. Keeps the newest hundred
/// deletions.
class DeletedObjects {
public:
    using Send = std::function<void(const protocol::Command& command)>;
    /// The command that would create an object as it is now; nullopt if it is not known to be in the world.
    using Look = std::function<std::optional<protocol::CreateObject>(const std::string& name)>;

    /// The other functions call `send` and `look` directly, before they return.
    DeletedObjects(Send send, Look look);

    /// Sends `deletion` and keeps `objects`, the commands that create the deleted objects again. If there are none, the
    /// deletion cannot be undone.
    void remove(const protocol::Command& deletion, std::vector<protocol::CreateObject> objects);
    bool canUndo() const { return stack_.canUndo(); }
    bool canRedo() const { return stack_.canRedo(); }
    /// Creates the objects of the last deletion again at their former places.
    void undo() { stack_.undo(); }
    /// Deletes the objects that the last undo created, by name; objects added since then stay. The next undo creates
    /// them in the state that they had at this second deletion.
    void redo() { stack_.redo(); }
    /// Forgets all deletions; to be called when the world changes.
    void clear() { stack_.clear(); }

private:
    Send send_;
    Look look_;
    QUndoStack stack_;
};

} // namespace usar::mission
