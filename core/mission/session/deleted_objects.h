// What a person has deleted from the world, and can bring back or delete again.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <QUndoStack>

#include "core/protocol/command.h"

namespace usar::mission {

/// Undo and redo of deletions. Belongs to whoever sends the commands, and to the same thread. Keeps the newest hundred
/// deletions.
class DeletedObjects {
public:
    using Send = std::function<void(const protocol::Command& command)>;
    /// The command that would create an object as it is now; nullopt where it is not known to be in the world.
    using Look = std::function<std::optional<protocol::CreateObject>(const std::string& name)>;

    /// Both are called by the other functions only, at once.
    DeletedObjects(Send send, Look look);

    /// Sends `deletion`, and keeps how the objects that it takes away are made again. Without any there is nothing to
    /// bring back.
    void remove(const protocol::Command& deletion, std::vector<protocol::CreateObject> objects);
    bool canUndo() const { return stack_.canUndo(); }
    bool canRedo() const { return stack_.canRedo(); }
    /// Makes the objects of the last deletion again, where they were.
    void undo() { stack_.undo(); }
    /// Deletes what the last undo has made, by name: what came into the world since then stays. The next undo makes
    /// them as they were when they were deleted again.
    void redo() { stack_.redo(); }
    /// For another world.
    void clear() { stack_.clear(); }

private:
    Send send_;
    Look look_;
    QUndoStack stack_;
};

} // namespace usar::mission
