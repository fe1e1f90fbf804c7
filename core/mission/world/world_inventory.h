// The objects of the world: the server's report, and facts about them that the server does not report.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/mission/world/world_session.h"

namespace usar::mission {

/// Keeps the objects that the server has reported, the waypoints and spins given to them here, the names in use, and
/// the classes of the objects with which the embedded world began. Belongs to one thread.
class WorldInventory {
public:
    /// Size of a class at a scale of 1, in meters along its own axes; nullopt for an unknown class.
    using SizeOfClass = std::function<std::optional<Vec3>(std::string_view class_name)>;

    explicit WorldInventory(SizeOfClass size_of_class) : size_of_class_(std::move(size_of_class)) {}

    /// Takes what the embedded simulator tells of its objects without being asked; their classes are those of `setOwn`.
    void setSeen(const protocol::WorldObjects& objects);
    /// Takes the server's newest report. Forgets the waypoints and spins of objects that no longer exist.
    void setThings(const std::vector<WorldThing>& things);
    const std::vector<WorldThing>& things() const { return things_; }
    /// nullptr if there is none of this name; valid until the next `setThings`.
    const WorldThing* find(std::string_view name) const;
    /// Classes, by name, of the objects that the embedded world began with; a class may be empty. Empty for a
    /// real server.
    void setOwn(std::map<std::string, std::string> classes) { own_classes_ = std::move(classes); }
    /// Prepares for another server. The objects stay until it reports its own.
    void clear();

    /// Returns `kinds` and the classes of the world's own objects, without their packages, to ask the server for them.
    std::vector<std::string> classesToAskFor(std::vector<std::string> kinds) const;
    /// Returns the first free name for an object of this class: "Crate1".
    std::string unusedName(const std::string& class_name) const;
    /// Marks the name as taken even before the server reports the object.
    void useName(const std::string& name) { used_names_.insert(name); }
    /// Returns the command that creates this object in its present state; nullopt if there is no such object, or if
    /// neither the server nor the embedded world knows its class.
    std::optional<protocol::CreateObject> creationOf(const std::string& name) const;

    /// The waypoints given to the object here, in meters in the map frame; empty if there are none.
    std::vector<Vec2> way_m(const std::string& name) const;
    void setWay(const std::string& name, std::vector<Vec2> way_m) { given_[name].way_m = std::move(way_m); }
    /// Toggles whether the object spins; returns true if it spins from now on.
    bool toggleSpin(const std::string& name) { return given_[name].spins = !given_[name].spins; }

private:
    struct Given {
        std::vector<Vec2> way_m;
        bool spins = false;
    };

    SizeOfClass size_of_class_;
    std::vector<WorldThing> things_;
    std::map<std::string, std::string> own_classes_; ///< by name
    std::map<std::string, Given> given_;             ///< by name
    std::set<std::string> used_names_;
};

} // namespace usar::mission
