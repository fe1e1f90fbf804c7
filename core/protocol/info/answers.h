// GEO, CONF and RES: the server's answers to GETGEO, GETCONF and SET.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/clock.h"
#include "core/base/geometry.h"

namespace usar::protocol {

/// The pose of an item on the chassis (mount "HARD") or on a part of the robot.
struct MountedItem {
    std::string name{};
    Pose item_in_mount{};
    std::string mount{};
    std::optional<Vec3> tip_in_item_m{}; ///< tip of a gripper or an arm (UDK)
    bool operator==(const MountedItem&) const = default;
};

/// GEO. `type` is the sensor type, or for a robot the word for its kind of vehicle; then `robot_class` is set and there
/// are no items. The empty answer that UT2004 sends for "no such thing" has neither class nor items. The items of a
/// mission package are its links, "CameraPanTilt_Link1", mounted on the chassis or on each other; these are the names
/// that the mounts of other items refer to.
/// On the wire: `GEO {Type Sonar} {Name F Location 1,0,0 Orientation 0,0,0 Mount HARD}`.
struct GeometryInfo {
    std::string type{};
    std::vector<MountedItem> items{};
    std::string robot_class{};
    std::optional<Vec3> dimensions_m{};        ///< length, width, height
    std::optional<Vec3> center_of_gravity_m{}; ///< in the robot's frame
    std::optional<double> wheel_radius_m{};
    std::optional<double> wheel_separation_m{};
    std::optional<double> wheel_base_m{};
    bool operator==(const GeometryInfo&) const = default;
};

/// A setting as it was sent; `number` is its value if that is a finite number.
struct Setting {
    std::string key{};
    std::string value{};
    std::optional<double> number{};
    bool operator==(const Setting&) const = default;
};

/// The settings of one sensor, part or robot.
struct ConfiguredItem {
    std::string name{}; ///< class name if the item is a robot
    std::vector<Setting> settings{};

    /// The first number under this key, ignoring case; nullopt if there is none.
    std::optional<double> number(const std::string& key) const;
    bool operator==(const ConfiguredItem&) const = default;
};

/// CONF of a robot, of sensors or of anything else. Settings keep the server's keys, order and units.
/// On the wire: `CONF {Type Sonar} {Name R8} {MaxRange 5.0000} {MinRange 0.1000} {BeamAngle 0.3491}`.
struct ConfigurationInfo {
    std::string type{};
    std::vector<ConfiguredItem> items{};
    bool operator==(const ConfigurationInfo&) const = default;
};

/// The result for one thing. `key` is Name, Config, Viewport1 …, `value` the text after it. A zoom of 0 resets a camera
/// to its default angle but still reports Failed (protocol.md 4.8).
struct ResponsePart {
    std::string key{};
    std::string value{};
    bool ok = false;
    std::optional<double> fov_rad{}; ///< for cameras only
    bool operator==(const ResponsePart&) const = default;
};

/// RES, the result of SET (UT2004 only). If one line reports several things (all cameras, viewports), `name` is the
/// first Name, `ok` is true only if all succeeded, and `parts` has the individual results.
/// On the wire: `RES {Time 120.40} {Type INS} {Name INS} {Status OK}`.
struct Response {
    std::optional<Seconds> time{};
    std::string type{};
    std::string name{};
    bool ok = false;
    std::vector<ResponsePart> parts{};
    std::optional<long long> tag_id{};   ///< id of an RFID tag that was read
    std::optional<std::string> memory{}; ///< text stored in that tag; may contain spaces
    bool operator==(const Response&) const = default;
};

} // namespace usar::protocol
