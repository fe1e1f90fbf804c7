// A world as plain values: terrain, plants, boxes, water, start poses, and what sensors other than range sensors find
// in it. Physics and ray casting are both built from it. Map frame, meters.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/geometry.h"
#include "core/sim/world/articulation.h"
#include "core/sim/world/terrain.h"

namespace usar::sim {

/// A sphere is centered on the top of the trunk; a cone stands on it.
enum class CrownShape { Sphere, Cone };

/// A tree or bush: a vertical trunk cylinder that stands on the ground, and a crown. A bush has a trunk height of 0.
struct Plant {
    Vec3 base_in_map_m = Vec3::Zero(); ///< where the trunk meets the ground
    double trunk_radius_m = 0.0;
    double trunk_height_m = 0.0;
    CrownShape crown = CrownShape::Sphere;
    double crown_radius_m = 0.0; ///< 0: no crown
    double crown_height_m = 0.0; ///< cones only; a cone stands on top of the trunk, a sphere is centered there
    bool operator==(const Plant&) const = default;
};

/// A solid box that never moves: a house, wall, shelf or ceiling.
struct Box {
    Pose center_in_map;
    /// Full extent along each axis of the box.
    Vec3 size_m = Vec3::Zero();
    bool operator==(const Box&) const = default;
};

/// A still water surface over the whole world. Range sensors do not see it.
struct Water {
    /// Height of the surface in the map frame, which is z up.
    double surface_z_m = 0.0;
    double density_kg_m3 = 1000.0; ///< fresh water by default
    bool operator==(const Water&) const = default;
};

/// A start pose, which a client can name in INIT.
struct NamedPose {
    std::string name;
    Pose pose_in_map;
    bool operator==(const NamedPose&) const = default;
};

/// A thing that robots can push or kick: one rigid body.
struct WorldObject {
    std::string name;
    std::string class_name; ///< its class on the wire, such as "USARModels.SoccerBall"; may be empty
    BodyDescription body;
    Pose body_in_map;                      ///< pose at the start of the simulation
    std::optional<BodyDescription> belt{}; ///< the moving surface, body frame; nullopt unless it is a conveyor
    bool operator==(const WorldObject&) const = default;
};

/// A tag that an RFID reader can find, read and write.
struct RfidTag {
    int id = 0; ///< 0 or more, unique in its world
    /// Text that robots can read and write.
    std::string memory;
    Vec3 position_in_map_m = Vec3::Zero();
    bool operator==(const RfidTag&) const = default;
};

/// Kinds of victim parts. `nameOf` depends on this order.
enum class VictimPartKind { Head, Arm, Hand, Chest, Pelvis, Leg, Foot };

/// One part of a victim's body.
struct VictimPart {
    VictimPartKind kind = VictimPartKind::Head;
    Vec3 position_in_map_m = Vec3::Zero();
    bool operator==(const VictimPart&) const = default;
};

/// A person to be found. The victim sensor reports parts, not persons.
struct Victim {
    std::string name;
    std::string status; ///< free text of the wire, such as "Calm"; those "Unconscious" or "Dead" do not move
    std::vector<VictimPart> parts;
    bool operator==(const Victim&) const = default;
};

/// A source of sound that never ends.
struct SoundSource {
    std::string name;
    double loudness_db = 0.0; ///< at a distance of 1 m
    Vec3 position_in_map_m = Vec3::Zero();
    bool operator==(const SoundSource&) const = default;
};

/// A source of gas at constant strength.
struct GasSource {
    std::string gas = "CO2";
    double density = 0.0; ///< reading of a sensor at a distance of 1 m
    Vec3 position_in_map_m = Vec3::Zero();
    bool operator==(const GasSource&) const = default;
};

/// Position of the map's origin on Earth; the map's x axis points north. Degrees, north and east positive, as in files
/// and on the wire, because the GPS sensor counts meters per degree. The default is that of the original simulator
/// (robots-and-worlds.md, 4.8).
struct GpsReference {
    double latitude_deg = 39.0 + 8.0273 / 60.0;
    double longitude_deg = -(77.0 + 12.998 / 60.0);
    bool operator==(const GpsReference&) const = default;
};

/// A complete world, read from a folder or generated. It does not change while a simulation runs.
struct World {
    std::string name; ///< reported as Level on the wire
    Terrain terrain;  ///< may be empty if there are boxes to stand on
    std::vector<Plant> plants;
    std::vector<Box> boxes;
    std::vector<WorldObject> objects;
    std::optional<Water> water;         ///< nullopt: the world is dry
    std::vector<NamedPose> start_poses; ///< a world file needs at least one
    std::vector<RfidTag> rfid_tags;
    std::vector<Victim> victims;
    std::vector<SoundSource> sounds;
    std::vector<GasSource> gases;
    GpsReference gps_reference;
    bool operator==(const World&) const = default;
};

/// Bounds of the terrain, or of all boxes if there is no terrain; empty if there is neither.
Rectangle extentOf(const World& world);

/// Map z above which all ground is dry: that of the water, or the world's lowest point if it has none.
double dryAbove_m(const World& world);

/// True for a point in the world or at most 1 km outside it on any side; nothing can be meant to be farther away.
bool isNear(const World& world, const Vec3& point_in_map_m);

/// The start pose with this name, in any case; nullptr if there is none.
const Pose* findStart(const World& world, std::string_view name);

/// The kind's word on the wire, such as "Head".
std::string_view nameOf(VictimPartKind kind);
/// The kind with exactly this word; nullopt if there is none.
std::optional<VictimPartKind> victimPartKind(std::string_view name);

} // namespace usar::sim
