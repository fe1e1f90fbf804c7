// A robot's cameras as its server tells of them: which there are, how they are zoomed and turned, and its headlight.
#pragma once

#include <deque>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/protocol/command.h"
#include "core/protocol/info/configurations.h"
#include "core/protocol/info_message.h"
#include "core/protocol/usual_values.h"

namespace usar::mission {

/// Folds a robot's messages and makes the commands that zoom and turn its cameras; it sends nothing itself. Servers
/// take one SET a tick, so SETs wait in a queue, and only the newest of each kind. Angles are radians. A plain value.
class CameraMount {
public:
    struct Camera {
        protocol::CameraConfiguration configuration;
        double fov_rad = protocol::usual_camera_fov_rad;
    };
    /// What a message changed for somebody who shows this.
    enum class News { None, Cameras, Picture, Abilities };

    News take(const protocol::InfoMessage& message);

    /// True once the server has said which cameras there are; there may be none.
    bool answered() const { return answered_; }
    const std::vector<Camera>& cameras() const { return cameras_; }
    /// Null while no camera is known.
    const Camera* shown() const { return shown_ < cameras_.size() ? &cameras_[shown_] : nullptr; }
    void show(const std::string& name);

    bool canZoom() const;
    /// Clamped to what the camera can do; queues a SET.
    void zoomTo(double fov_rad);
    void zoomBy(double factor);
    void resetZoom();

    bool canTurn() const { return package_.has_value(); }
    /// In parts of the camera's angle of view; false if the mount cannot turn.
    bool turnBy(double right, double up);
    /// Two links pan and tilt; a single link tilts, as AirRobot's does. False if the mount cannot turn.
    bool turn(double right_rad, double up_rad);
    void center();
    /// MISPKG for where the mount should point; absent if it cannot turn or its name cannot be sent.
    std::optional<protocol::PackageDrive> drive() const;
    /// While turns are on their way the mount's own reports are old and are ignored.
    void setTurning(bool turning) { turning_ = turning; }

    bool lightKnown() const { return light_on_.has_value(); }
    bool lightOn() const { return light_on_.value_or(false); }

    /// Takes the place of a waiting SET of the same kind.
    void queue(const protocol::Command& set);
    /// The next SET to send, which leaves the queue.
    std::optional<protocol::Command> next();
    /// True once after the server answered a SET: the next one may follow.
    bool takeAnswered();

private:
    struct Package {
        std::string name;
        std::map<int, double> wanted_rad; ///< by link
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
