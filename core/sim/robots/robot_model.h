// A kind of robot as plain values: the content of a robot file (resources/robots/README.md), from which robots are
// built.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/clock.h"
#include "core/protocol/info/robot_state.h"
#include "core/sim/world/articulation.h"

namespace usar::sim {

/// Settings by name, in SI units and radians. Each part of the program ignores those that it does not know.
using Numbers = std::map<std::string, double, std::less<>>;

/// The number by this name, or `otherwise` if there is none.
inline double numberOr(const Numbers& numbers, std::string_view key, double otherwise) {
    const auto found = numbers.find(key);
    return found == numbers.end() ? otherwise : found->second;
}

/// A link that is connected to another one by a joint. The frames of links are those of the file, whereas those of the
/// physics have their origins in the centers of mass.
struct ModelLink {
    std::string name;
    std::string joint; ///< name of the joint that connects it to its parent
    Vec3 center_of_mass_in_link_m = Vec3::Zero();
    double torque_limit = 0.0; ///< N m or N, of that joint
    double speed_limit = 0.0;  ///< rad/s or m/s
};

/// The drive of a robot and its settings. `joints` are those that it drives, in the order that this kind needs.
struct DriveModel {
    std::string kind; ///< as in `makeDrive`
    std::vector<std::string> joints;
    Numbers numbers;
};

/// A sensor and its settings: `numbers` are those that read as numbers, `words` all others.
struct SensorModel {
    std::string type; ///< its type on the wire: Sonar, RangeScanner …
    std::string name;
    int link = -1; ///< index of the link that carries it; -1: the base
    Pose sensor_in_link;
    std::string mount; ///< as GEO reports it: HARD for the chassis, or the name of a part
    Numbers numbers;
    std::map<std::string, std::string, std::less<>> words;
};

/// A mission package: joints that MISPKG moves, the one nearest to the base first.
struct PackageModel {
    std::string name;
    std::vector<std::string> joints;
    /// The point that a pose given to MISPKG is about; absent: where the last joint is.
    std::optional<Vec3> tip_in_last_link_m{};
};

/// A gripper: joints whose links close like fingers, open at 0.
struct GripperModel {
    std::string name;
    std::string package; ///< that carries it; empty if it is on the chassis
    std::vector<std::string> joints;
    Vec3 tip_in_holder_m = Vec3::Zero(); ///< between the fingers, in the frame of the link that they hang on
};

/// Everything about one class of robots. Frames are those of the file, except in `body`.
struct RobotModel {
    std::string class_name;             ///< without "USARBot."
    std::vector<std::string> aliases{}; ///< other classes that clients send for it
    protocol::VehicleKind kind = protocol::VehicleKind::Ground;
    std::string steering;                    ///< SteeringType in CONF
    Vec3 dimensions_m = Vec3::Zero();        ///< length, width, height, as GEO reports them
    Vec3 center_of_gravity_m = Vec3::Zero(); ///< as GEO reports it; physics uses `center_of_mass_in_base_m`
    Seconds battery_life{1200.0};
    Vec3 center_of_mass_in_base_m = Vec3::Zero();
    ArticulatedDescription body;
    std::vector<ModelLink> links; ///< parallel to `body.links`
    DriveModel drive;
    std::vector<SensorModel> sensors;
    std::vector<PackageModel> packages;
    std::vector<GripperModel> grippers{};

    /// Mass of the base and all links.
    double mass_kg() const;
    /// All parts as one rigid body whose origin is that of the base, with joints at 0; for finding a free place.
    BodyDescription whole() const;
    /// Index of the link on this joint, whose name must match exactly; nullopt if there is none.
    std::optional<int> linkOnJoint(std::string_view joint) const;
};

/// The robots that can be spawned. Class names are compared without regard to case.
using RobotCatalog = std::vector<RobotModel>;

/// "AirRobot" for "USARBot.AirRobot".
std::string_view withoutPackage(std::string_view class_name);

/// Finds a robot by its class, or by an alias that is no robot's class, in any case, with or without its package
/// ("USARBot.AirRobot"); nullptr if there is none.
const RobotModel* findRobot(const RobotCatalog& robots, std::string_view class_name);

} // namespace usar::sim
