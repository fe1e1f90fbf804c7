// Obeys CONTROL: makes, moves and removes things while the simulation runs (usarsim-protocol 5.8).
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/protocol/command.h"
#include "core/protocol/info/world_objects.h"
#include "core/sim/scene.h"

namespace usar::sim {

/// Where the things are that it works on. All of it outlives it.
class WorldController {
public:
    WorldController(const World& world, Physics& physics, Scene& scene)
        : world_(world)
        , physics_(physics)
        , scene_(scene) {}

    static bool isControl(const protocol::Command& command);
    /// A sentence where the command cannot be obeyed, for the server's log.
    std::optional<std::string> obey(const protocol::Command& command, std::uint32_t client);
    protocol::WorldObjects states(const protocol::GetObjectStates& asked) const;
    /// Things that are not permanent leave with who made them.
    void clientLeft(std::uint32_t client);

private:
    using Answer = std::optional<std::string>;
    Answer create(const protocol::CreateObject& wanted, std::uint32_t client);
    /// What is to be made, but for its name and place: a thing that the world begins with, by its name and, if it has
    /// one, its class; one of our kinds; or one of the world's classes.
    Answer describe(const protocol::CreateObject& wanted, WorldObject& object) const;
    Answer startOf(const protocol::CreateObject& wanted, Pose& start_in_map) const;
    std::string knownClasses() const;
    Answer move(const protocol::Token& name, const Pose& body_in_map);
    Answer runConveyor(const protocol::RunConveyor& wanted);
    /// Raised by up to a meter until nothing is in its way: what is dropped on a slope or a thing lands on it.
    bool makeRoom(SceneObject& object);
    Answer follow(const protocol::FollowWaypoints& wanted);
    template <class Keep>
    void removeUnless(Keep&& keep);
    SceneObject* find(std::string_view name) const;
    Answer missing(std::string_view name) const;

    const World& world_;
    Physics& physics_;
    Scene& scene_;
};

} // namespace usar::sim
