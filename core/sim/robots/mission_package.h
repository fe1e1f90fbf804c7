// A mission package: joints that MISPKG moves, a camera's pan and tilt or an arm.
#pragma once

#include <vector>

#include "core/protocol/command.h"
#include "core/protocol/info/answers.h"
#include "core/protocol/info/packages.h"
#include "core/sim/robots/robot_body.h"

namespace usar::sim {

/// Holds its joints where they are until it is told otherwise. `body` must outlive it.
class MissionPackage {
public:
    MissionPackage(const PackageModel& model, RobotBody& body);

    const std::string& name() const { return model_.name; }
    /// MISPKG in both its forms, and ACT; false for what is meant for another package.
    bool obey(const protocol::Command& command);
    void switchOff();

    protocol::PackageState state(Seconds now) const;
    /// Its links as GEO's items, each named after its place: "CameraPanTilt_Link1".
    std::vector<protocol::MountedItem> geometry() const;
    std::vector<protocol::Setting> settings() const;

private:
    void move(int link, double value, protocol::LinkOrder order);
    const ModelLink& link(std::size_t index) const;

    PackageModel model_;
    RobotBody& body_;
    std::vector<std::size_t> links_; ///< of the body
};

} // namespace usar::sim
