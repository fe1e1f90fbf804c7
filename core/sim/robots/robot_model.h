// A kind of robot as plain values: what a robot file says (resources/robots/README.md) and a robot is built from.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/clock.h"
#include "core/protocol/info/robot_state.h"
#include "core/sim/articulation.h"

namespace usar::sim {

/// Settings by name, SI units and radians. What a part of the program does not know it leaves alone.
using Numbers = std::map<std::string, double, std::less<>>;

inline double numberOr(const Numbers& numbers, std::string_view key, double otherwise) {
    const auto found = numbers.find(key);
    return found == numbers.end() ? otherwise : found->second;
}

/// A link that hangs on another by a joint. Frames of links are those of the file; physics has its origins in the
/// centers of mass instead.
struct ModelLink {
    std::string name;
    std::string joint; ///< name of the joint that it hangs on
    Vec3 center_of_mass_in_link_m = Vec3::Zero();
    double torque_limit = 0.0; ///< of that joint: N m or N
    double speed_limit = 0.0;  ///< rad/s or m/s
};

/// What makes it move, with its settings; `joints` are the joints that it drives, in the order of its kind.
struct DriveModel {
    std::string kind; ///< rotors, skid, ackermann, nautic, legs
    std::vector<std::string> joints;
    Numbers numbers;
};

struct SensorModel {
    std::string type; ///< on the wire: Sonar, RangeScanner …
    std::string name;
    int link = -1; ///< index of the link that carries it; -1: the base
    Pose sensor_in_link;
    std::string mount; ///< as GEO tells it: HARD for the chassis, or the name of a part
    Numbers numbers;
    std::map<std::string, std::string, std::less<>> words;
};

/// A mission package: joints that MISPKG moves, the first one nearest to the base.
struct PackageModel {
    std::string name;
    std::vector<std::string> joints;
};

struct RobotModel {
    std::string class_name; ///< without "USARBot."
    protocol::VehicleKind kind = protocol::VehicleKind::Ground;
    std::string steering; ///< SteeringType of CONF
    Vec3 dimensions_m = Vec3::Zero();
    Vec3 center_of_gravity_m = Vec3::Zero();
    Seconds battery_life{1200.0};
    Vec3 center_of_mass_in_base_m = Vec3::Zero();
    ArticulatedDescription body;
    std::vector<ModelLink> links; ///< as `body.links`
    DriveModel drive;
    std::vector<SensorModel> sensors;
    std::vector<PackageModel> packages;

    double mass_kg() const;
    /// All parts as one rigid body with its origin in the base's, joints at 0: for finding a free place.
    BodyDescription whole() const;
    /// Index of the link on this joint; nothing where there is none.
    std::optional<int> linkOnJoint(std::string_view joint) const;
};

/// The robots that can be spawned, by class name without regard to case.
using RobotCatalog = std::vector<RobotModel>;

/// "AirRobot" of "USARBot.AirRobot".
std::string_view withoutPackage(std::string_view class_name);

/// With or without its package, "USARBot.AirRobot"; nullptr where there is none.
const RobotModel* findRobot(const RobotCatalog& robots, std::string_view class_name);

} // namespace usar::sim
