// A robot's cameras as its server reports them: which cameras exist, their zoom and mount, and the robot's headlight.
#pragma once

#include <deque>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/protocol/command.h"
#include "core/protocol/info/configurations.h"
#include "core/protocol/info_message.h"
#include "core/protocol/usual_values.h"

namespace usar::mission {

/// Collects the state from a robot's messages and makes the commands that zoom and turn its cameras; it sends nothing
/// itself. Servers take one SET a tick, so SETs wait in a queue, and only the newest of each kind. Angles are radians.
/// A plain value.
class CameraMount {
public:
    struct Camera {
        protocol::CameraConfiguration configuration;
        double fov_rad = protocol::usual_camera_fov_rad; ///< current angle of view
    };
    /// The change that a message made for the display: the list of cameras, the angle of view, or what can be turned or
    /// lit.
    enum class News { None, Cameras, Picture, Abilities };

    News take(const protocol::InfoMessage& message);

    /// True once the server has said which cameras there are; there may be none.
    bool answered() const { return answered_; }
    const std::vector<Camera>& cameras() const { return cameras_; }
    /// Null while no camera is known.
    const Camera* shown() const { return shown_ < cameras_.size() ? &cameras_[shown_] : nullptr; }
    void show(const std::string& name);

    bool canZoom() const;
    /// Queues a SET for this angle of view, clamped to the camera's range.
    void zoomTo(double fov_rad);
    void zoomBy(double factor);
    void resetZoom();

    bool canTurn() const { return package_.has_value(); }
    /// Turns by fractions of the camera's angle of view; returns false if the mount cannot turn.
    bool turnBy(double right, double up);
    /// Two links pan and tilt; a single link tilts, as AirRobot's does. Returns false if the mount cannot turn.
    bool turn(double right_rad, double up_rad);
    void center();
    /// Returns the MISPKG command that points the mount as requested; nullopt if it cannot turn or its name cannot be
    /// sent.
    std::optional<protocol::PackageDrive> drive() const;
    /// While turns are on their way the mount's own reports are old and are ignored.
    void setTurning(bool turning) { turning_ = turning; }

    bool lightKnown() const { return light_on_.has_value(); }
    bool lightOn() const { return light_on_.value_or(false); }

    /// Queues a SET; it replaces a waiting SET of the same kind.
    void queue(const protocol::Command& set);
    /// Removes and returns the next SET to send; nullopt if none is waiting.
    std::optional<protocol::Command> next();
    /// True once after the server answered a SET: the next one may follow.
    bool takeAnswered() { return std::exchange(set_answered_, false); }

private:
    struct Package {
        std::string name;
        std::map<int, double> wanted_rad; ///< angles in radians, by link
    };

    News takeCameras(const std::vector<protocol::CameraConfiguration>& cameras);
    News takePackage(const protocol::PackageState& state);
    News takeResponse(const protocol::Response& response);
    News takeLight(const protocol::RobotState& state);

    std::vector<Camera> cameras_;
    std::size_t shown_ = 0;
    bool answered_ = false;
    std::optional<Package> package_;
    bool turning_ = false;
    std::optional<bool> light_on_;
    std::deque<protocol::Command> sets_;
    bool set_answered_ = false;
};

} // namespace usar::mission
