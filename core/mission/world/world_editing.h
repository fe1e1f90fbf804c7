// The user's edits of the world: what is sent for each of them, what is remembered of it, and how it is taken back.
#pragma once

#include <string>
#include <vector>

#include "core/mission/world/object_edits.h"
#include "core/mission/world/world_edits.h"
#include "core/mission/world/world_inventory.h"

namespace usar::mission {

/// Turns edits into commands for the world controller, and records a step for each that can be undone. Objects are
/// named as the server names them; an edit of an unknown object sends what it can, because only the server decides.
/// Belongs to one thread; lengths are in meters in the map frame, angles in radians.
class WorldEditing {
public:
    /// What the edits need of others; all is called directly, before a function returns.
    struct World {
        WorldInventory::SizeOfClass size_of_class;
        ObjectEdits::Send send;
        GroundHeight ground;               ///< at the moment of the call, which may be that of an undo
        std::function<void()> way_changed; ///< the waypoints of an object are others now
    };

    /// The history must outlive this object.
    WorldEditing(EditHistory& history, World world);

    WorldInventory& inventory() { return inventory_; }
    const WorldInventory& inventory() const { return inventory_; }
    /// Prepares for another server: nothing of this one can be undone any more.
    void clear();

    /// Creates an object under a free name, which is returned. Fails if a line cannot contain the class name.
    Result<std::string> place(NewObject object, const Vec2& at_m);
    /// Moves its center here, at the same height over the ground; an unknown object stays.
    void moveTo(const std::string& name, const Vec2& center_m);
    /// Turns it about the vertical axis, positive to the left.
    void turn(const std::string& name, double angle_rad) { edits_.turn(name, angle_rad); }
    /// Starts to spin it, or ends that; no step of the history.
    void toggleSpin(const std::string& name);
    /// Appends a waypoint at the object's height over the ground; has no effect for an unknown object.
    void addWaypoint(const std::string& name, const Vec2& at_m);
    void clearWay(const std::string& name) { changeWay(name, {}); }
    /// Starts or stops its motion along its waypoints; a conveyor without waypoints runs its belt. No step.
    void follow(const std::string& name, bool is_conveyor, const Motion& motion);
    /// Deletes the object. Returns the names of those that undo cannot restore; empty for an unknown object.
    std::vector<std::string> remove(const std::string& name);
    /// The same for all objects.
    std::vector<std::string> removeAll();

private:
    std::vector<std::string> remove(const std::vector<std::string>& names, const protocol::Command& deletion);
    /// Sets the waypoints as an edit.
    void changeWay(const std::string& name, const std::vector<Vec2>& way_m);
    /// Sets the waypoints here and in the world; has no effect for an unknown object.
    void setWay(const std::string& name, const std::vector<Vec2>& way_m);

    World world_;
    WorldInventory inventory_;
    ObjectEdits edits_;
};

} // namespace usar::mission
