// Edits of the objects in the world, with their steps in the history.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/mission/edits/edit_history.h"
#include "core/protocol/command.h"

namespace usar::mission {

/// Sends the commands of edits and records how to take them back. Each call is a step of its own. Runs in the thread of
/// its owner.
class ObjectEdits {
public:
    using Send = std::function<void(const protocol::Command& command)>;
    /// The command that would create an object as it is now; nullopt if it is not known to be in the world.
    using Look = std::function<std::optional<protocol::CreateObject>(const std::string& name)>;
    /// Sets an object's waypoints, in meters of the map frame, here and in the world.
    using SetWay = std::function<void(const std::vector<Vec2>& way_m)>;

    /// The history must outlive this object. The other functions call `send` and `look` directly, before they return.
    ObjectEdits(EditHistory& history, Send send, Look look);

    /// Sends `deletion` and keeps `objects`, the commands that create the deleted objects again. If there are none, the
    /// deletion cannot be undone. A redo deletes by name what the undo created, so that objects added since then stay;
    /// the next undo creates them in the state that they had at this second deletion.
    void remove(const protocol::Command& deletion, std::vector<protocol::CreateObject> objects);
    /// Undo deletes the object.
    void place(const protocol::CreateObject& object);
    /// Undo moves the object back to `from`, a pose of its body in the map frame.
    void move(const std::string& name, const Pose& from_in_map, const Pose& to_in_map);
    /// Turns about the vertical axis, positive to the left. Undo turns it back.
    void turn(const std::string& name, double angle_rad);
    /// Calls `set` with `after_m`; undo calls it with `before_m`.
    void setWay(const std::string& name, const std::vector<Vec2>& before_m, const std::vector<Vec2>& after_m,
                const SetWay& set);
    /// The world is gone: nothing of this can be undone any more.
    void forget();

private:
    /// Does this, and adds a step.
    void add(const QString& text, const std::function<void()>& redo, const std::function<void()>& undo);

    EditHistory& history_;
    Send send_;
    Look look_;
};

} // namespace usar::mission
