// Obeys CONTROL: creates, moves and removes objects while the simulation runs (protocol.md 5.8).
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/protocol/command.h"
#include "core/protocol/info/world_objects.h"
#include "core/sim/physics/scene.h"

namespace usar::sim {

/// Works on the objects of one simulation. World, physics and scene must outlive it.
class WorldController {
public:
    WorldController(const World& world, Physics& physics, Scene& scene)
        : world_(world)
        , physics_(physics)
        , scene_(scene) {}

    /// True for the commands that only a world controller's connection may send.
    static bool isControl(const protocol::Command& command);
    /// Obeys a command of this client. Returns a sentence for the server's log if that is impossible.
    std::optional<std::string> obey(const protocol::Command& command, std::uint32_t client);
    /// States of the objects with the name and class that were asked for; an empty name or class matches all.
    protocol::WorldObjects states(const protocol::GetObjectStates& asked) const;
    /// Removes the objects that this client created and did not make permanent.
    void clientLeft(std::uint32_t client);

private:
    using Answer = std::optional<std::string>; ///< nullopt: done; otherwise the reason why not
    Answer create(const protocol::CreateObject& wanted, std::uint32_t client);
    /// Determines what to create, without its name and pose. Candidates in this order: an object that the world starts
    /// with, by its name and, if it has one, its class; one of the built-in kinds; any of the world's objects of this
    /// class.
    Answer describe(const protocol::CreateObject& wanted, WorldObject& object) const;
    Answer startOf(const protocol::CreateObject& wanted, Pose& start_in_map) const;
    std::string knownClasses() const;
    Answer move(SceneObject& object, const Pose& body_in_map);
    /// Raises the object by up to a meter until nothing is in its way, so that it lands on the slope or thing that it
    /// is dropped on. Returns false, with the object where it was, if there is no room.
    bool makeRoom(SceneObject& object);
    // Each obeys a command about one object.
    Answer act(SceneObject& object, const protocol::KillObject& kill);
    Answer act(SceneObject& object, const protocol::PlaceObject& wanted) { return move(object, wanted.object_in_map); }
    Answer act(SceneObject& object, const protocol::ShiftObject& wanted);
    Answer act(SceneObject& object, const protocol::RunConveyor& wanted);
    Answer act(SceneObject& object, const protocol::AddWaypoints& wanted);
    Answer act(SceneObject& object, const protocol::FollowWaypoints& wanted);
    Answer act(SceneObject& object, const protocol::SpinObject& wanted) {
        object.motion.spin_rad_s = wanted.rates_rad_s;
        return {};
    }
    Answer act(SceneObject& object, const protocol::ClearWaypoints&) {
        object.motion = {.spin_rad_s = object.motion.spin_rad_s};
        return {};
    }
    template <class Keep>
    void removeUnless(Keep&& keep);
    /// The object by this name, in any case; nullptr if there is none.
    SceneObject* find(std::string_view name) const;

    const World& world_;
    Physics& physics_;
    Scene& scene_;
};

} // namespace usar::sim
