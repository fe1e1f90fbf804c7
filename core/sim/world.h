// A world as plain values: terrain, plants, boxes, water, start poses, and what sensors other than rays find in it.
// What physics and rays are both built from. Map frame, metres.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/geometry.h"
#include "core/sim/articulation.h"
#include "core/sim/terrain.h"

namespace usar::sim {

enum class CrownShape { Sphere, Cone };

/// A tree or bush: a vertical trunk cylinder from the ground and a crown. A bush has a trunk height of 0.
struct Plant {
    Vec3 base_in_map_m = Vec3::Zero(); ///< where the trunk meets the ground
    double trunk_radius_m = 0.0;
    double trunk_height_m = 0.0;
    CrownShape crown = CrownShape::Sphere;
    double crown_radius_m = 0.0;
    double crown_height_m = 0.0; ///< cones only; a cone stands on top of the trunk, a sphere is centered there
    bool operator==(const Plant&) const = default;
};

/// A house, wall, shelf or ceiling.
struct Box {
    Pose center_in_map;
    Vec3 size_m = Vec3::Zero();
    bool operator==(const Box&) const = default;
};

/// A still surface over the whole world; range sensors do not see it.
struct Water {
    double surface_z_m = 0.0;
    double density_kg_m3 = 1000.0;
    bool operator==(const Water&) const = default;
};

struct NamedPose {
    std::string name;
    Pose pose_in_map;
    bool operator==(const NamedPose&) const = default;
};

/// A thing that robots push and kick: one rigid body.
struct WorldObject {
    std::string name;
    std::string class_name; ///< the wire's word for its kind, as "USARModels.SoccerBall"
    BodyDescription body;
    Pose body_in_map;                      ///< when the simulation begins
    std::optional<BodyDescription> belt{}; ///< of a conveyor, in the body's frame: the part whose surface runs
    bool operator==(const WorldObject&) const = default;
};

/// What an RFID reader finds and writes to.
struct RfidTag {
    int id = 0;
    std::string memory;
    Vec3 position_in_map_m = Vec3::Zero();
    bool operator==(const RfidTag&) const = default;
};

/// In the order of `nameOf`.
enum class VictimPartKind { Head, Arm, Hand, Chest, Pelvis, Leg, Foot };

struct VictimPart {
    VictimPartKind kind = VictimPartKind::Head;
    Vec3 position_in_map_m = Vec3::Zero();
    bool operator==(const VictimPart&) const = default;
};

/// A person to be found; the victim sensor sees parts, not persons.
struct Victim {
    std::string name;
    std::string status; ///< free text of the wire, as "Calm"
    std::vector<VictimPart> parts;
    bool operator==(const Victim&) const = default;
};

struct SoundSource {
    std::string name;
    double loudness_db = 0.0; ///< 1 m away
    Vec3 position_in_map_m = Vec3::Zero();
    bool operator==(const SoundSource&) const = default;
};

struct GasSource {
    std::string gas = "CO2";
    double density = 0.0; ///< what a sensor 1 m away reads
    Vec3 position_in_map_m = Vec3::Zero();
    bool operator==(const GasSource&) const = default;
};

/// Where the map's origin lies on Earth, x to the north. In degrees, north and east positive, as in files and on the
/// wire: the GPS counts metres a degree. The default is that of the original simulator (robots-and-worlds, 4.8).
struct GpsReference {
    double latitude_deg = 39.0 + 8.0273 / 60.0;
    double longitude_deg = -(77.0 + 12.998 / 60.0);
    bool operator==(const GpsReference&) const = default;
};

struct World {
    std::string name; ///< Level on the wire
    Terrain terrain;  ///< may be empty where boxes are all there is to stand on
    std::vector<Plant> plants;
    std::vector<Box> boxes;
    std::vector<WorldObject> objects;
    std::optional<Water> water;
    std::vector<NamedPose> start_poses;
    std::vector<RfidTag> rfid_tags;
    std::vector<Victim> victims;
    std::vector<SoundSource> sounds;
    std::vector<GasSource> gases;
    GpsReference gps_reference;
    bool operator==(const World&) const = default;
};

/// The ground's, or all boxes' where there is none.
Rectangle extentOf(const World& world);

/// The wire's word: "Head", "Arm"...
std::string_view nameOf(VictimPartKind kind);
std::optional<VictimPartKind> victimPartKind(std::string_view name);

} // namespace usar::sim
