// How a robot is fitted out: its kind and size, where its sensors are mounted and how far they reach, and the limits of
// its joints; out of its STA and of the answers GEO and CONF.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "core/base/geometry.h"
#include "core/protocol/info/configurations.h"
#include "core/protocol/info_message.h"

namespace usar::widgets {

/// To be fed with every message of one robot, no matter who asked for the answers. Types and names of sensors are
/// compared ignoring case. A plain value.
class Fitting {
public:
    void take(const protocol::InfoMessage& message);

    /// By STA, CONF or GEO; Unknown until one of them tells. A UDK server's STA does not tell of those that fly.
    protocol::VehicleKind kind() const { return kind_; }
    /// Length, width, height; nullopt until GEO told.
    const std::optional<Vec3>& dimensions_m() const { return dimensions_m_; }
    /// "SkidSteered", "AckermanSteered" …; empty until CONF told.
    const std::string& steering() const { return steering_; }
    /// Pose of a sensor on the robot's base; nullopt until GEO told, and for a sensor on a moving part, whose place
    /// changes.
    std::optional<Pose> mount(const std::string& type, const std::string& name) const;
    /// What CONF told about a sensor; nullptr until then.
    const protocol::SensorConfiguration* settings(const std::string& type, const std::string& name) const;
    /// The limits of a joint of a mission package; nullptr if CONF told none.
    const protocol::LinkConfiguration* joint(const std::string& package, long long link) const;
    /// True if the sensor looks down, or up if `sign` is -1: more than 45 degrees from level. False if unknown.
    bool looksDown(const std::string& type, const std::string& name, double sign = 1.0) const;

private:
    using Key = std::pair<std::string, std::string>; ///< type and name in lower case

    protocol::VehicleKind kind_ = protocol::VehicleKind::Unknown;
    std::optional<Vec3> dimensions_m_;
    std::string steering_;
    std::string robot_class_; ///< a UDK server names it as the mount of what is fixed to the base
    std::map<Key, protocol::MountedItem> mounts_;
    std::map<Key, protocol::SensorConfiguration> settings_;
    std::map<std::string, protocol::PackageConfiguration> packages_; ///< by name in lower case
};

} // namespace usar::widgets
