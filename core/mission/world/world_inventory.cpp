#include "core/mission/world/world_inventory.h"

#include <algorithm>

#include "core/base/text.h"
#include "core/mission/world/world_edits.h"

namespace usar::mission {

namespace {

constexpr double scale_tolerance = 0.02; // Servers round sizes.

} // namespace

void WorldInventory::setThings(const std::vector<WorldThing>& things) {
    things_ = things;
    std::erase_if(given_, [this](const auto& given) { return !find(given.first); });
}

void WorldInventory::setSeen(const protocol::WorldObjects& objects) {
    std::vector<WorldThing> things;
    for (const protocol::WorldObject& object : objects.objects) {
        const auto own = own_classes_.find(object.name);
        const std::string class_name = own == own_classes_.end() ? std::string() : own->second;
        things.push_back({object.name, withoutPackage(class_name), object.size_m, object.object_in_map});
    }
    setThings(things);
}

const WorldThing* WorldInventory::find(std::string_view name) const {
    const auto found = std::ranges::find(things_, name, &WorldThing::name);
    return found == things_.end() ? nullptr : &*found;
}

void WorldInventory::clear() {
    own_classes_.clear();
    given_.clear();
    used_names_.clear();
}

std::vector<std::string> WorldInventory::classesToAskFor(std::vector<std::string> kinds) const {
    for (const auto& [name, class_name] : own_classes_)
        if (const std::string bare = withoutPackage(class_name); std::ranges::find(kinds, bare) == kinds.end())
            kinds.push_back(bare);
    return kinds;
}

std::string WorldInventory::unusedName(const std::string& class_name) const {
    const std::string bare = withoutPackage(class_name);
    for (int number = 1;; ++number)
        if (const std::string name = bare + std::to_string(number); !used_names_.contains(name) && !find(name))
            return name;
}

std::optional<protocol::CreateObject> WorldInventory::creationOf(const std::string& name) const {
    const WorldThing* const thing = find(name);
    if (!thing)
        return std::nullopt;
    const auto own = own_classes_.find(name);
    const bool is_own =
        own != own_classes_.end() && (own->second.empty() || thing->class_name.empty() ||
                                      sameWord(withoutPackage(own->second), withoutPackage(thing->class_name)));
    if (thing->class_name.empty() && !is_own)
        return std::nullopt;
    protocol::CreateObject created{tokenOf(is_own ? own->second : thing->class_name)}; // "unnamed" without a class
    created.object_name = protocol::Name::mended(name);
    created.start = thing->body_in_map;
    const std::optional<Vec3> class_size_m = is_own ? std::nullopt : size_of_class_(thing->class_name);
    if (!class_size_m || !thing->size_m)
        return created; // at the normal size of its class
    if (const Vec3 scale = thing->size_m->cwiseQuotient(*class_size_m); !scale.isApprox(Vec3::Ones(), scale_tolerance))
        created.scale = scale;
    return created;
}

std::vector<Vec2> WorldInventory::way_m(const std::string& name) const {
    const auto given = given_.find(name);
    return given == given_.end() ? std::vector<Vec2>() : given->second.way_m;
}

} // namespace usar::mission
