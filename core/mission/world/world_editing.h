// The user's edits of the world: what is sent for each of them, and what is remembered of it.
#pragma once

#include <string>
#include <vector>

#include "core/mission/world/deleted_objects.h"
#include "core/mission/world/world_edits.h"
#include "core/mission/world/world_inventory.h"

namespace usar::mission {

/// Turns edits into commands for the world controller. Objects are named as the server names them; an edit of an
/// unknown object sends what it can, because only the server decides. Belongs to one thread; lengths are in meters in
/// the map frame, angles in radians.
class WorldEditing {
public:
    /// `send` is called directly, before a function returns.
    WorldEditing(WorldInventory::SizeOfClass size_of_class, const DeletedObjects::Send& send);

    WorldInventory& inventory() { return inventory_; }
    const WorldInventory& inventory() const { return inventory_; }
    DeletedObjects& deleted() { return deleted_; }
    const DeletedObjects& deleted() const { return deleted_; }
    /// Prepares for another server.
    void clear();

    /// Creates an object under a free name, which is returned. Fails if a line cannot contain the class name.
    Result<std::string> place(NewObject object, const Vec2& at_m, const GroundHeight& ground);
    /// Moves its center here, at the same height over the ground; an unknown object stays.
    void moveTo(const std::string& name, const Vec2& center_m, const GroundHeight& ground);
    /// Turns it about the vertical axis, positive to the left.
    void turn(const std::string& name, double angle_rad);
    /// Starts to spin it, or ends that.
    void toggleSpin(const std::string& name);
    /// Appends a waypoint at the object's height over the ground; has no effect for an unknown object.
    void addWaypoint(const std::string& name, const Vec2& at_m, const GroundHeight& ground);
    void clearWay(const std::string& name);
    /// Starts or stops its motion along its waypoints; a conveyor without waypoints runs its belt.
    void follow(const std::string& name, bool is_conveyor, const Motion& motion);
    /// Deletes the object. Returns the names of those that undo cannot restore; empty for an unknown object.
    std::vector<std::string> remove(const std::string& name);
    /// The same for all objects.
    std::vector<std::string> removeAll();

private:
    std::vector<std::string> remove(const std::vector<std::string>& names, const protocol::Command& deletion);

    DeletedObjects::Send send_;
    WorldInventory inventory_;
    DeletedObjects deleted_;
};

} // namespace usar::mission
