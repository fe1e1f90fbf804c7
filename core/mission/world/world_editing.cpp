#include "core/mission/world/world_editing.h"

#include <utility>

namespace usar::mission {

namespace {

constexpr double object_spin_rad_s = radians(30.0);

} // namespace

WorldEditing::WorldEditing(EditHistory& history, World world)
    : world_(std::move(world))
    , inventory_(world_.size_of_class)
    , edits_(history, world_.send, [this](const std::string& name) { return inventory_.creationOf(name); }) {}

void WorldEditing::clear() {
    inventory_.clear();
    edits_.forget();
}

Result<std::string> WorldEditing::place(NewObject object, const Vec2& at_m) {
    object.name = inventory_.unusedName(object.class_name);
    const auto created = placed(object, at_m, world_.ground(at_m));
    if (!created)
        return tl::unexpected(created.error());
    inventory_.useName(object.name);
    edits_.place(*created);
    return object.name;
}

void WorldEditing::moveTo(const std::string& name, const Vec2& center_m) {
    if (const WorldThing* const thing = inventory_.find(name))
        edits_.move(name, thing->body_in_map, movedTo(thing->body_in_map, center_m, world_.ground));
}

void WorldEditing::toggleSpin(const std::string& name) {
    const bool spins = inventory_.toggleSpin(name);
    world_.send(protocol::SpinObject{tokenOf(name), Vec3(0.0, 0.0, spins ? object_spin_rad_s : 0.0)});
}

void WorldEditing::addWaypoint(const std::string& name, const Vec2& at_m) {
    if (!inventory_.find(name))
        return;
    std::vector<Vec2> way_m = inventory_.way_m(name);
    way_m.push_back(at_m);
    changeWay(name, way_m);
}

void WorldEditing::changeWay(const std::string& name, const std::vector<Vec2>& way_m) {
    edits_.setWay(name, inventory_.way_m(name), way_m,
                  [this, name](const std::vector<Vec2>& now_m) { setWay(name, now_m); });
}

void WorldEditing::setWay(const std::string& name, const std::vector<Vec2>& way_m) {
    const WorldThing* const thing = inventory_.find(name);
    if (!thing)
        return;
    const bool grows = way_m.size() == inventory_.way_m(name).size() + 1; // Then its motion goes on.
    inventory_.setWay(name, way_m);
    std::vector<Vec3> points_m;
    for (std::size_t i = grows ? way_m.size() - 1 : 0; i < way_m.size(); ++i)
        points_m.push_back(waypointAt(thing->body_in_map, way_m[i], world_.ground));
    if (!grows)
        world_.send(protocol::ClearWaypoints{tokenOf(name)});
    if (!points_m.empty())
        world_.send(protocol::AddWaypoints{tokenOf(name), points_m});
    world_.way_changed();
}

void WorldEditing::follow(const std::string& name, bool is_conveyor, const Motion& motion) {
    world_.send(motionOf(name, is_conveyor, !inventory_.way_m(name).empty(), motion));
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
    edits_.remove(deletion, std::move(kept));
    return lost;
}

} // namespace usar::mission
