#include "core/sim/world_controller.h"

#include <algorithm>

#include "core/base/sealed.h"
#include "core/base/text.h"
#include "core/sim/robots/robot_model.h"
#include "core/sim/world/object_kinds.h"

namespace usar::sim {

namespace {

constexpr const char* too_far = "its place is more than 1 km outside the world";

} // namespace

bool WorldController::isControl(const protocol::Command& command) {
    using namespace protocol;
    using Controls = std::variant<CreateObject, KillObject, KillAllObjects, PlaceObject, ShiftObject, SpinObject,
                                  RunConveyor, AddWaypoints, ClearWaypoints, FollowWaypoints, GetObjectStates>;
    return std::visit([](const auto& one) { return AlternativeOf<decltype(one), Controls>; },
                      static_cast<const CommandVariant&>(command));
}

SceneObject* WorldController::find(std::string_view name) const {
    const auto found =
        std::ranges::find_if(scene_.objects, [name](const SceneObject& one) { return sameWord(one.name, name); });
    return found == scene_.objects.end() ? nullptr : &*found;
}

template <class Keep>
void WorldController::removeUnless(Keep&& keep) {
    std::erase_if(scene_.objects, [&](const SceneObject& object) {
        if (keep(object))
            return false;
        removeObject(object, physics_);
        return true;
    });
}

WorldController::Answer WorldController::create(const protocol::CreateObject& wanted, std::uint32_t client) {
    if (!wanted.object_name.text().empty() && find(wanted.object_name))
        return "there is an object '" + wanted.object_name.text() + "' already";
    WorldObject object;
    if (const Answer trouble = describe(wanted, object))
        return trouble;
    object.name = wanted.object_name.text();
    object.class_name = wanted.class_name.text();
    const std::string bare_name(withoutPackage(object.class_name));
    for (std::size_t number = scene_.objects.size() + 1; object.name.empty(); ++number)
        if (const std::string free = bare_name + std::to_string(number); !find(free))
            object.name = free;
    if (const Answer trouble = startOf(wanted, object.body_in_map))
        return trouble;
    SceneObject& added = addObject(scene_, physics_, object);
    if (!makeRoom(added)) {
        removeObject(added, physics_);
        scene_.objects.pop_back();
        return "something, such as a tree, is in the way there; choose another place";
    }
    added.memory = wanted.memory;
    if (!wanted.permanent.value_or(false))
        added.goes_with = client;
    return {};
}

WorldController::Answer WorldController::describe(const protocol::CreateObject& wanted, WorldObject& object) const {
    const Vec3 scale = wanted.scale.value_or(Vec3::Ones());
    if (!(scale.minCoeff() > 0.0) || scale.maxCoeff() > 100.0)
        return "an object's scale must be above 0 and at most 100";
    const std::string_view bare_name = withoutPackage(wanted.class_name.text());
    const auto ofClass = [&](const WorldObject& one) { return sameWord(withoutPackage(one.class_name), bare_name); };
    auto own = std::ranges::find_if(world_.objects, [&](const WorldObject& one) {
        return !wanted.scale && (ofClass(one) || one.class_name.empty()) && sameWord(one.name, wanted.object_name);
    });
    const ObjectKind* const kind = findObjectKind(wanted.class_name.text());
    if (own == world_.objects.end() && !kind)
        own = std::ranges::find_if(world_.objects, ofClass);
    if (own != world_.objects.end()) {
        if (!scale.isOnes())
            return "an object of class '" + wanted.class_name.text() +
                   "' cannot be scaled, because it is one of the world's own";
        object = *own;
        return {};
    }
    if (!kind)
        return "unknown object class '" + wanted.class_name.text() + "'; known are " + knownClasses();
    object.body = bodyOf(*kind, scale);
    object.belt = beltOf(*kind, scale);
    return {};
}

WorldController::Answer WorldController::startOf(const protocol::CreateObject& wanted, Pose& start_in_map) const {
    if (const auto* const pose = std::get_if<Pose>(&wanted.start)) {
        start_in_map = *pose;
        return isNear(world_, pose->position_m) ? Answer() : too_far;
    }
    const auto& name = std::get<protocol::Token>(wanted.start);
    const Pose* const start = findStart(world_, name);
    if (!start)
        return "there is no start pose '" + name.text() + "'";
    start_in_map = *start;
    return {};
}

std::string WorldController::knownClasses() const {
    std::string names = objectKindNames();
    for (const WorldObject& object : world_.objects)
        if (const std::string bare_name(withoutPackage(object.class_name));
            !findObjectKind(bare_name) && names.find(bare_name) == std::string::npos)
            names += ", " + bare_name;
    return names;
}

bool WorldController::makeRoom(SceneObject& object) {
    constexpr double step_m = 0.05;
    constexpr int most_steps = 20;
    if (object.belt)
        return true; // A conveyor stands still, so it may overlap the ground.
    const Pose wanted = object.body_in_map;
    Pose raised = wanted;
    const Vec2 point_m = wanted.position_m.head<2>();
    if (const Terrain& ground = world_.terrain; !ground.empty() && ground.extent().contains(point_m))
        if (const double ground_m = ground.height_m(point_m); wanted.position_m.z() < ground_m)
            raised.position_m.z() = ground_m + object.size_m.z() / 2.0;
    if (raised != wanted)
        placeObject(object, physics_, raised);
    for (int i = 0; i < most_steps && physics_.isStuck(object.body); ++i) {
        raised.position_m.z() += step_m;
        placeObject(object, physics_, raised);
    }
    if (!physics_.isStuck(object.body))
        return true;
    placeObject(object, physics_, wanted);
    return false;
}

WorldController::Answer WorldController::move(SceneObject& object, const Pose& body_in_map) {
    if (!isNear(world_, body_in_map.position_m))
        return too_far;
    placeObject(object, physics_, body_in_map);
    makeRoom(object); // Without room it stays where it was told to be.
    return {};
}

WorldController::Answer WorldController::act(SceneObject&, const protocol::KillObject& kill) {
    removeUnless([&](const SceneObject& one) { return !sameWord(one.name, kill.object_name); });
    return {};
}

WorldController::Answer WorldController::act(SceneObject& object, const protocol::ShiftObject& wanted) {
    Pose moved = object.body_in_map;
    moved.position_m += wanted.shift.position_m;
    moved.roll_rad += wanted.shift.roll_rad;
    moved.pitch_rad += wanted.shift.pitch_rad;
    moved.yaw_rad += wanted.shift.yaw_rad;
    return move(object, moved);
}

WorldController::Answer WorldController::act(SceneObject& object, const protocol::RunConveyor& wanted) {
    if (!object.belt)
        return "'" + object.name + "' is not a conveyor";
    physics_.runSurface(*object.belt, {wanted.speed_m_s, 0.0, 0.0});
    return {};
}

WorldController::Answer WorldController::act(SceneObject& object, const protocol::AddWaypoints& wanted) {
    auto& points = object.motion.waypoints_in_map_m;
    points.insert(points.end(), wanted.points_in_map_m.begin(), wanted.points_in_map_m.end());
    return {};
}

WorldController::Answer WorldController::act(SceneObject& object, const protocol::FollowWaypoints& wanted) {
    ObjectMotion& motion = object.motion;
    if (const auto* const speed = std::get_if<protocol::WaypointSpeed>(&wanted.pace)) {
        motion.speed_m_s = speed->speed_m_s;
    } else {
        double way_m = 0.0;
        Vec3 at_m = object.body_in_map.position_m;
        for (const Vec3& point_m : motion.waypoints_in_map_m) {
            way_m += (point_m - at_m).norm();
            at_m = point_m;
        }
        const double time_s = std::get<Seconds>(wanted.pace).count();
        motion.speed_m_s = time_s > 0.0 ? way_m / time_s : 0.0;
    }
    motion.loop = wanted.loop.value_or(motion.loop);
    motion.moving = wanted.moving.value_or(true);
    return {};
}

WorldController::Answer WorldController::obey(const protocol::Command& command, std::uint32_t client) {
    if (const auto* const wanted = std::get_if<protocol::CreateObject>(&command))
        return create(*wanted, client);
    if (const auto* const kill = std::get_if<protocol::KillAllObjects>(&command)) {
        removeUnless([&](const SceneObject& one) {
            return kill->within &&
                   !Eigen::AlignedBox3d(kill->within->min_m, kill->within->max_m).contains(one.body_in_map.position_m);
        });
        return {};
    }
    return std::visit(
        [&](const auto& one) -> Answer {
            if constexpr (requires(SceneObject & object) { act(object, one); }) {
                SceneObject* const object = find(one.object_name);
                return object ? act(*object, one) : "there is no object '" + one.object_name.text() + "'";
            }
            return {};
        },
        static_cast<const protocol::CommandVariant&>(command));
}

protocol::WorldObjects WorldController::states(const protocol::GetObjectStates& asked) const {
    protocol::WorldObjects states;
    for (const SceneObject& object : scene_.objects) {
        const bool named = asked.object_name.text().empty() || sameWord(asked.object_name, object.name);
        const std::string_view asked_class = withoutPackage(asked.class_name.text());
        // WCObject is the class that all others of UDK are made from.
        const bool of_class = asked_class.empty() || sameWord(asked_class, "WCObject") ||
                              sameWord(asked_class, withoutPackage(object.class_name));
        if (named && of_class)
            states.objects.push_back({object.name, object.size_m, object.body_in_map, object.memory});
    }
    return states;
}

void WorldController::clientLeft(std::uint32_t client) {
    removeUnless([client](const SceneObject& one) { return one.goes_with != client; });
}

} // namespace usar::sim
