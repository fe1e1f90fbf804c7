#include "core/mission/world/world_editing.h"

#include <utility>

namespace usar::mission {

namespace {

constexpr double object_spin_rad_s = radians(30.0);

} // namespace

WorldEditing::WorldEditing(WorldInventory::SizeOfClass size_of_class, const DeletedObjects::Send& send)
    : send_(send)
    , inventory_(std::move(size_of_class))
    , deleted_(send, [this](const std::string& name) { return inventory_.creationOf(name); }) {}

void WorldEditing::clear() {
    inventory_.clear();
    deleted_.clear();
}

Result<std::string> WorldEditing::place(NewObject object, const Vec2& at_m, const GroundHeight& ground) {
    object.name = inventory_.unusedName(object.class_name);
    const auto created = placed(object, at_m, ground(at_m));
    if (!created)
        return tl::unexpected(created.error());
    inventory_.useName(object.name);
    send_(*created);
    return object.name;
}

void WorldEditing::moveTo(const std::string& name, const Vec2& center_m, const GroundHeight& ground) {
    if (const WorldThing* const thing = inventory_.find(name))
        send_(protocol::PlaceObject{tokenOf(name), movedTo(thing->body_in_map, center_m, ground)});
}

void WorldEditing::turn(const std::string& name, double angle_rad) {
    Pose shift;
    shift.yaw_rad = angle_rad;
    send_(protocol::ShiftObject{tokenOf(name), shift});
}

void WorldEditing::toggleSpin(const std::string& name) {
    const bool spins = inventory_.toggleSpin(name);
    send_(protocol::SpinObject{tokenOf(name), Vec3(0.0, 0.0, spins ? object_spin_rad_s : 0.0)});
}

void WorldEditing::addWaypoint(const std::string& name, const Vec2& at_m, const GroundHeight& ground) {
    const WorldThing* const thing = inventory_.find(name);
    if (!thing)
        return;
    inventory_.addWaypoint(name, at_m);
    send_(protocol::AddWaypoints{tokenOf(name), {waypointAt(thing->body_in_map, at_m, ground)}});
}

void WorldEditing::clearWay(const std::string& name) {
    inventory_.clearWay(name);
    send_(protocol::ClearWaypoints{tokenOf(name)});
}

void WorldEditing::follow(const std::string& name, bool is_conveyor, const Motion& motion) {
    send_(motionOf(name, is_conveyor, !inventory_.way_m(name).empty(), motion));
}

std::vector<std::string> WorldEditing::remove(const std::string& name) {
    return inventory_.find(name) ? remove({name}, protocol::KillObject{tokenOf(name)}) : std::vector<std::string>();
}

std::vector<std::string> WorldEditing::removeAll() {
    std::vector<std::string> names;
    for (const WorldThing& thing : inventory_.things())
        names.push_back(thing.name);
    return remove(names, protocol::KillAllObjects{});
}

std::vector<std::string> WorldEditing::remove(const std::vector<std::string>& names,
                                              const protocol::Command& deletion) {
    std::vector<protocol::CreateObject> kept;
    std::vector<std::string> lost;
    for (const std::string& name : names)
        if (auto created = inventory_.creationOf(name))
            kept.push_back(*std::move(created));
        else
            lost.push_back(name);
    deleted_.remove(deletion, std::move(kept));
    return lost;
}

} // namespace usar::mission
