// Callbacks through which a client's session acts on its simulation.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "core/base/clock.h"
#include "core/protocol/command.h"
#include "core/protocol/info_message.h"
#include "core/sim/camera/camera_scene.h"
#include "core/sim/robots/robot.h"

namespace usar::sim {

/// Made by the simulation for one call of the session.
struct SessionHost {
    using Log = std::function<void(std::string)>;

    /// Spawns a robot with the name that the INIT has, or returns nullptr; the log tells that and `why` the name.
    std::function<std::unique_ptr<Robot>(const protocol::Init&, const std::string& why)> spawn;
    /// The name that an INIT's robot or station gets: the wanted one, or another one and the reason for it.
    std::function<std::pair<std::string, std::string>(const protocol::Init&)> nameOf;
    /// Pose of a base station; nullopt if it is refused. It logs as `spawn` does.
    std::function<std::optional<Pose>(const protocol::Init&, const std::string& why)> stationAt;
    /// Obeys a CONTROL. Returns a sentence if that is impossible.
    std::function<std::optional<std::string>(const protocol::Command&)> control;
    std::function<protocol::WorldObjects(const protocol::GetObjectStates&)> objectStates;
    /// Obeys AttachCamera and DetachCamera. Returns false if there is no such camera or viewer.
    std::function<bool(const protocol::Command&)> attach;
    std::function<void(const Viewports&)> show; ///< sets the viewports; the robot has these cameras
    std::function<Viewports()> shown;           ///< the current viewports
    /// Left and top edge of this robot's camera in the window that all cameras share, in pixels.
    std::function<std::pair<int, int>(const std::string& camera)> place_of;
    Log log;
    Seconds now{0.0};
};

} // namespace usar::sim
