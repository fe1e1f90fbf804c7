// A mission package: joints that MISPKG moves, such as a camera's pan and tilt, or an arm.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/protocol/command.h"
#include "core/protocol/info/answers.h"
#include "core/protocol/info/packages.h"
#include "core/sim/robots/robot_body.h"

namespace usar::sim {

/// Its joints start at 0 and are held where they were last told to be. `body` must outlive it.
class MissionPackage {
public:
    MissionPackage(const PackageModel& model, RobotBody& body);

    const std::string& name() const { return model_.name; }
    /// Obeys all forms of MISPKG, and ACT. Returns false for a command that is meant for another package.
    bool obey(const protocol::Command& command);
    /// The reason why the last pose was not obeyed, for the log; nullopt if it was, and after it has been taken.
    std::optional<std::string> takeTrouble() { return std::exchange(trouble_, {}); }
    /// Turns the joints' motors off.
    void switchOff();

    protocol::PackageState state(Seconds now) const;
    /// Its links as items of GEO, each named by its position: "CameraPanTilt_Link1".
    std::vector<protocol::MountedItem> geometry() const;
    /// Its part of CONF: for each link its number, kind of joint, and limits.
    std::vector<protocol::Setting> settings() const;

private:
    /// Links are counted from 1; the value is in rad or m, rad/s or m/s, N m or N, depending on the order.
    void move(int link, double value, protocol::LinkOrder order);
    /// Moves all joints so that the tip gets there, or none if that is impossible.
    void reach(const protocol::PackagePose& wanted);
    const ModelLink& link(std::size_t index) const;

    PackageModel model_;
    RobotBody& body_;
    std::vector<std::size_t> links_; ///< indices of the body's links, the one nearest to the base first
    std::optional<std::string> trouble_;
};

} // namespace usar::sim
