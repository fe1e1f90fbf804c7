// GEO, CONF and RES: what the server answers to GETGEO, GETCONF and SET.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/clock.h"
#include "core/base/geometry.h"

namespace usar::protocol {

/// Where an item sits: on the chassis (mount "HARD") or on a part of the robot.
struct MountedItem {
    std::string name{};
    Pose item_in_mount{};
    std::string mount{};
    std::optional<Vec3> tip_in_item_m{}; ///< of a gripper or an arm (UDK)
    bool operator==(const MountedItem&) const = default;
};

/// GEO. `type` is the sensor type, or the vehicle kind's word for a robot (then `robot_class` is set and there are no
/// items). The bare head that UT2004 sends for "no such thing" has neither. A mission package's items are its links,
/// "CameraPanTilt_Link1", mounted on the chassis or on each other: the names that other items' mounts use.
struct GeometryInfo {
    std::string type{};
    std::vector<MountedItem> items{};
    std::string robot_class{};
    std::optional<Vec3> dimensions_m{}; ///< length, width, height
    std::optional<Vec3> center_of_gravity_m{};
    std::optional<double> wheel_radius_m{};
    std::optional<double> wheel_separation_m{};
    std::optional<double> wheel_base_m{};
    bool operator==(const GeometryInfo&) const = default;
};

/// A setting as it was sent; the number where the value is one.
struct Setting {
    std::string key{};
    std::string value{};
    std::optional<double> number{};
    bool operator==(const Setting&) const = default;
};

struct ConfiguredItem {
    std::string name{}; ///< for a robot its class
    std::vector<Setting> settings{};

    /// The first number under this key, without regard to case.
    std::optional<double> number(const std::string& key) const;
    bool operator==(const ConfiguredItem&) const = default;
};

/// CONF of a robot, of sensors, of anything: settings keep the server's keys, order and units.
struct ConfigurationInfo {
    std::string type{};
    std::vector<ConfiguredItem> items{};
    bool operator==(const ConfigurationInfo&) const = default;
};

/// One thing that a result tells of. `key` is Name, Config, Viewport1 …, `value` what follows it. A zoom of 0 resets a
/// camera to its default angle and yet reports Failed (usarsim-protocol 4.8).
struct ResponsePart {
    std::string key{};
    std::string value{};
    bool ok = false;
    std::optional<double> fov_rad{}; ///< of a camera
    bool operator==(const ResponsePart&) const = default;
};

/// RES, the result of SET (UT2004 only). Where one line tells of several things (all cameras, viewports), `name` is the
/// first and `ok` means that every one of them is; `parts` has them one by one.
struct Response {
    std::optional<Seconds> time{};
    std::string type{};
    std::string name{};
    bool ok = false;
    std::vector<ResponsePart> parts{};
    std::optional<long long> tag_id{};   ///< of an RFID tag that was read
    std::optional<std::string> memory{}; ///< of that tag; may hold spaces
    bool operator==(const Response&) const = default;
};

} // namespace usar::protocol
