#include "core/mission/world/deleted_objects.h"

#include <utility>

#include "core/mission/world/world_edits.h"

namespace usar::mission {

namespace {

constexpr int most_deletions = 100;

/// QUndoStack calls redo() for the deletion itself, too.
class Deletion : public QUndoCommand {
public:
    Deletion(protocol::Command first, std::vector<protocol::CreateObject> objects, const DeletedObjects::Send& send,
             const DeletedObjects::Look& look)
        : first_(std::move(first))
        , objects_(std::move(objects))
        , send_(send)
        , look_(look) {}

    void redo() override {
        if (const auto first = std::exchange(first_, std::nullopt))
            return send_(*first);
        for (protocol::CreateObject& object : objects_) {
            if (auto now = look_(object.object_name.text()))
                object = *std::move(now);
            send_(protocol::KillObject{tokenOf(object.object_name.text())});
        }
    }
    void undo() override {
        for (const protocol::CreateObject& object : objects_)
            send_(object);
    }

private:
    std::optional<protocol::Command> first_; ///< until it is sent
    std::vector<protocol::CreateObject> objects_;
    const DeletedObjects::Send& send_; ///< owned by the owner of the stack, as is `look_`
    const DeletedObjects::Look& look_;
};

} // namespace

DeletedObjects::DeletedObjects(Send send, Look look) : send_(std::move(send)), look_(std::move(look)) {
    stack_.setUndoLimit(most_deletions);
}

void DeletedObjects::remove(const protocol::Command& deletion, std::vector<protocol::CreateObject> objects) {
    if (objects.empty())
        return send_(deletion);
    stack_.push(new Deletion(deletion, std::move(objects), send_, look_)); // the stack owns it
}

} // namespace usar::mission
