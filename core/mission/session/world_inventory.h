// What is known of the objects of the world besides what the server tells of them.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/mission/session/world_session.h"

namespace usar::mission {

/// The things that the server has reported, the ways and spins that they were given here, names that are taken, and
/// classes of what the embedded world began with. Belongs to one thread.
class WorldInventory {
public:
    /// Size of a class at a scale of 1, in meters along its own axes; nullopt for a class that we do not know.
    using SizeOfClass = std::function<std::optional<Vec3>(std::string_view class_name)>;

    explicit WorldInventory(SizeOfClass size_of_class) : size_of_class_(std::move(size_of_class)) {}

    /// The server's newest report. What was given to a thing that is gone is forgotten.
    void setThings(const std::vector<WorldThing>& things);
    const std::vector<WorldThing>& things() const { return things_; }
    /// nullptr if there is none of this name; valid until the next `setThings`.
    const WorldThing* find(std::string_view name) const;
    /// Classes, by name, of the objects that the embedded world began with; a class may be empty. None on a server.
    void setOwn(std::map<std::string, std::string> classes) { own_classes_ = std::move(classes); }
    /// For another server. The things stay until it reports its own.
    void clear();

    /// `kinds`, and the classes of the world's own objects, without their packages: what the server is asked for.
    std::vector<std::string> classesToAskFor(std::vector<std::string> kinds) const;
    /// "Crate1": the first free name for an object of this class.
    std::string unusedName(const std::string& class_name) const;
    /// From now on the name is not free any more, even before the server reports the object.
    void useName(const std::string& name) { used_names_.insert(name); }
    /// The command that makes this object again as it is now. Nothing for one that is not there, and where neither the
    /// server nor the embedded world tells of which class it is.
    std::optional<protocol::CreateObject> creationOf(const std::string& name) const;

    /// The way that the object was given here, in meters of the map frame.
    std::vector<Vec2> way_m(const std::string& name) const;
    void addWaypoint(const std::string& name, const Vec2& at_m) { given_[name].way_m.push_back(at_m); }
    void clearWay(const std::string& name) { given_[name].way_m.clear(); }
    /// Whether it spins from now on: by turns yes and no.
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
