#include "core/sim/world/world_reader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include <sdf/sdf.hh>

#include "core/base/numbers.h"
#include "core/sim/world/height_png.h"
#include "core/sim/world/plant_csv.h"
#include "core/sim/world/sdf_fields.h"

namespace usar::sim {

namespace {

std::optional<Vec3> positionIn(const sdf::Element& element) {
    const auto numbers = numbersIn<3>(element);
    return numbers ? std::optional(Vec3(numbers->data())) : std::nullopt;
}

/// The number at the end of a path of child elements, or `otherwise` if the path ends early.
double numberAt(sdf::ElementPtr element, std::initializer_list<const char*> path, double otherwise) {
    for (const char* name : path) {
        if (!element->HasElement(name))
            return otherwise;
        element = element->GetElement(name);
    }
    return element->Get<double>();
}

/// A body that has only the surface of this collision.
BodyDescription surfaceOf(const sdf::Collision& collision) {
    const sdf::ElementPtr element = collision.Element();
    BodyDescription body;
    body.friction = numberAt(element, {"surface", "friction", "bullet", "friction"}, body.friction);
    body.restitution = numberAt(element, {"surface", "bounce", "restitution_coefficient"}, body.restitution);
    body.rolling_friction_m =
        numberAt(element, {"surface", "friction", "bullet", "rolling_friction"}, body.rolling_friction_m);
    return body;
}

bool isSound(const BodyDescription& surface) {
    return surface.friction >= 0.0 && surface.restitution >= 0.0 && surface.restitution <= 1.0 &&
           surface.rolling_friction_m >= 0.0;
}

/// Reads mass and inertia of a link. Returns the pose of the body's frame in the link's, or what is wrong.
Result<Pose, std::string> readInertial(const sdf::Link& link, BodyDescription& body) {
    const ignition::math::Inertiald& inertial = link.Inertial();
    if (!link.Element()->HasElement("inertial"))
        return tl::unexpected(std::string("needs an inertial with its mass"));
    // Vectors are not compared, because ignition's count as equal within 1e-3.
    if (inertial.MassMatrix().OffDiagonalMoments().SquaredLength() > 0.0)
        return tl::unexpected(std::string("needs its inertia about its main axes: turn the inertial's pose"));
    body.mass_kg = inertial.MassMatrix().Mass();
    body.inertia_kg_m2 = toVec3(inertial.MassMatrix().DiagonalMoments());
    if (!(body.mass_kg > 0.0) || !(body.inertia_kg_m2.minCoeff() > 0.0))
        return tl::unexpected(std::string("needs a mass and an inertia above zero"));
    return toPose(inertial.Pose());
}

/// The shape with sizes above zero, or what is wrong with it.
Result<BodyPart, std::string> readPart(const sdf::Collision& collision) {
    const auto shape = shapeIn(*collision.Geom());
    if (!shape)
        return tl::unexpected(std::string("has a shape that is neither a box, a sphere, a cylinder nor a capsule"));
    if (!(shape->smallest_m > 0.0))
        return tl::unexpected(std::string("has a shape without size"));
    return BodyPart{shape->shape, toPose(collision.RawPose())};
}

constexpr const char* two_grounds = "the world has two grounds: there may be one height map or one plane";

/// Builds a world from the elements of one file.
class WorldReading {
public:
    explicit WorldReading(const std::filesystem::path& file) : file_(file) {}

    Result<World> read(const sdf::World& source) {
        world_.name = source.Name();
        for (uint64_t i = 0; i < source.ModelCount(); ++i)
            if (auto done = readModel(*source.ModelByIndex(i)); !done)
                return tl::unexpected(done.error());
        for (sdf::ElementPtr element = source.Element()->GetFirstElement(); element;
             element = element->GetNextElement())
            if (auto done = readMark(*element); !done)
                return tl::unexpected(done.error());
        if (world_.terrain.empty() && world_.boxes.empty())
            return refuse("the world has no ground: no collision with a height map, a plane or a box",
                          *source.Element());
        if (world_.start_poses.empty())
            return refuse("the world has no usar:start_pose, so no robot can start", *source.Element());
        return std::move(world_);
    }

private:
    Result<void> readModel(const sdf::Model& model) {
        if (!model.Static())
            return readObject(model);
        if (model.ModelCount() != 0)
            return refuse("model \"" + model.Name() + "\" has models in it: give each a place in the world",
                          *model.Element());
        for (uint64_t l = 0; l < model.LinkCount(); ++l) {
            const sdf::Link& link = *model.LinkByIndex(l);
            for (uint64_t c = 0; c < link.CollisionCount(); ++c)
                if (auto done = readCollision(model, link, *link.CollisionByIndex(c)); !done)
                    return done;
        }
        return {};
    }

    Result<void> readCollision(const sdf::Model& model, const sdf::Link& link, const sdf::Collision& collision) {
        const Pose collision_in_map = toPose(model.RawPose()) * (toPose(link.RawPose()) * toPose(collision.RawPose()));
        switch (collision.Geom()->Type()) {
        case sdf::GeometryType::HEIGHTMAP:
            return readHeightmap(*collision.Geom()->HeightmapShape(), collision_in_map);
        case sdf::GeometryType::PLANE:
            return readFloor(*collision.Geom()->PlaneShape(), collision_in_map);
        case sdf::GeometryType::BOX:
            if (!(collision.Geom()->BoxShape()->Size().Min() > 0.0))
                return refuse("model \"" + model.Name() + "\" has a box without size", *collision.Element());
            world_.boxes.push_back({collision_in_map, toVec3(collision.Geom()->BoxShape()->Size())});
            return {};
        default:
            return refuse("model \"" + model.Name() +
                              "\" has a shape that is neither a box nor a plane nor a height map",
                          *collision.Element());
        }
    }

    Result<void> readHeightmap(const sdf::Heightmap& heightmap, const Pose& collision_in_map) {
        if (!world_.terrain.empty())
            return refuse(two_grounds, *heightmap.Element());
        auto image = readHeightPng(file_.parent_path() / heightmap.Uri());
        if (!image)
            return tl::unexpected(image.error());
        const auto side = [](std::size_t posts) { return static_cast<double>(posts - 1); };
        const ignition::math::Vector3d& size_m = heightmap.Size();
        if (image->columns < 2 || image->rows < 2)
            return refuse("the height map has fewer than 2 x 2 posts", *heightmap.Element());
        const double step_m = size_m.X() / side(image->columns);
        if (!(step_m > 0.0) || std::abs(size_m.Y() / side(image->rows) - step_m) > 1e-9 * step_m ||
            !(size_m.Z() >= 0.0))
            return refuse("the size of the height map does not fit its picture of " + std::to_string(image->columns) +
                              " x " + std::to_string(image->rows) +
                              " posts: posts must be equally far apart in x and y",
                          *heightmap.Element());
        const Vec3 center_m = collision_in_map.position_m + toVec3(heightmap.Position());
        std::vector<float> heights_m(image->values.size());
        for (std::size_t row = 0; row < image->rows; ++row)
            for (std::size_t column = 0; column < image->columns; ++column)
                heights_m[(image->rows - 1 - row) * image->columns + column] = static_cast<float>(
                    center_m.z() + size_m.Z() * image->values[row * image->columns + column] / 65535.0);
        world_.terrain = Terrain(image->columns, image->rows, step_m,
                                 center_m.head<2>() - Vec2{size_m.X(), size_m.Y()} / 2.0, std::move(heights_m));
        return {};
    }

    Result<void> readFloor(const sdf::Plane& plane, const Pose& collision_in_map) {
        if (!world_.terrain.empty())
            return refuse(two_grounds, *plane.Element());
        const Vec3 up = collision_in_map.rotation() * toVec3(plane.Normal());
        if (up.z() < 1.0 - 1e-9 || collision_in_map.yaw_rad != 0.0)
            return refuse("a plane is a floor: it must lie level and along x and y", *plane.Element());
        const Vec2 half_m = Vec2(plane.Size().X(), plane.Size().Y()) / 2.0;
        const Vec2 center_m = collision_in_map.position_m.head<2>();
        auto floor = Terrain::level({center_m - half_m, center_m + half_m}, collision_in_map.position_m.z());
        if (!floor)
            return refuse(
                "the sides of the plane need a common measure that is not too small, such as 1 m or 0.1 m, above zero",
                *plane.Element());
        world_.terrain = *std::move(floor);
        return {};
    }

    /// Reads a movable object: one link with a mass and with collisions of box, sphere, cylinder or capsule, all of one
    /// surface.
    Result<void> readObject(const sdf::Model& model) {
        const auto refuseObject = [&](const std::string& what, const sdf::ElementPtr& element) {
            return refuse("the object \"" + model.Name() + "\" " + what, *element);
        };
        if (model.LinkCount() != 1 || model.ModelCount() != 0)
            return refuseObject("must be one link; static models may have more", model.Element());
        const sdf::Link& link = *model.LinkByIndex(0);
        const bool touches = link.CollisionCount() > 0;
        const BodyDescription surface = touches ? surfaceOf(*link.CollisionByIndex(0)) : BodyDescription{};
        WorldObject object{model.Name(), textOf(*model.Element(), "usar:class_name"), surface, {}};
        const auto center_in_link = readInertial(link, object.body);
        if (!center_in_link)
            return refuseObject(center_in_link.error(), link.Element());
        if (!touches)
            return refuseObject("has no collision, so it would fall forever", link.Element());
        for (std::uint64_t c = 0; c < link.CollisionCount(); ++c) {
            const sdf::Collision& collision = *link.CollisionByIndex(c);
            auto part = readPart(collision);
            if (!part)
                return refuseObject(part.error(), collision.Element());
            if (!isSound(surface) || surfaceOf(collision) != surface)
                return refuseObject(
                    "needs one surface for all its collisions, restitution within 0..1, friction from 0 up",
                    collision.Element());
            part->part_in_body = inverse(*center_in_link) * part->part_in_body;
            object.body.parts.push_back(*part);
        }
        object.body_in_map = toPose(model.RawPose()) * (toPose(link.RawPose()) * *center_in_link);
        world_.objects.push_back(std::move(object));
        return {};
    }

    /// Adds what one child of the world element says; ignores SDFormat's own elements and fails for unknown usar: ones.
    Result<void> readMark(sdf::Element& element) {
        using Read = Result<void> (WorldReading::*)(sdf::Element&);
        static constexpr std::array<std::pair<std::string_view, Read>, 8> marks{
            {{"usar:scatter", &WorldReading::readScatter},
             {"usar:water", &WorldReading::readWater},
             {"usar:start_pose", &WorldReading::readStartPose},
             {"usar:rfid_tag", &WorldReading::readRfidTag},
             {"usar:victim", &WorldReading::readVictim},
             {"usar:sound", &WorldReading::readSound},
             {"usar:gas", &WorldReading::readGas},
             {"usar:gps_reference", &WorldReading::readGpsReference}}};
        const std::string& name = element.GetName();
        if (!name.starts_with("usar:"))
            return {};
        const auto mark = std::ranges::find(marks, name, &std::pair<std::string_view, Read>::first);
        if (mark == marks.end())
            return refuse("there is no element named " + name + " in a world", element);
        return (this->*mark->second)(element);
    }

    Result<void> readScatter(sdf::Element& element) {
        const std::string uri = textOf(element, "usar:uri");
        if (uri.empty())
            return refuse("a usar:scatter needs a usar:uri", element);
        auto plants = readPlantCsv(file_.parent_path() / uri);
        if (!plants)
            return tl::unexpected(plants.error());
        world_.plants.insert(world_.plants.end(), plants->begin(), plants->end());
        return {};
    }

    Result<void> readWater(sdf::Element& element) {
        const auto number = [&](const std::string& name) {
            const auto value = readNumber(textOf(element, name));
            return value && std::isfinite(*value) ? value : std::nullopt;
        };
        const auto surface_z_m = number("usar:surface_z");
        const auto density_kg_m3 = number("usar:density");
        if (!surface_z_m || !density_kg_m3 || !(*density_kg_m3 > 0.0))
            return refuse("a usar:water needs a usar:surface_z and a usar:density above zero", element);
        if (world_.water)
            return refuse("there is a second usar:water, but one water covers the whole world", element);
        world_.water = Water{*surface_z_m, *density_kg_m3};
        return {};
    }

    Result<void> readStartPose(sdf::Element& element) {
        const auto name = attributeOf(element, "name");
        const auto numbers = numbersIn<6>(element);
        if (!name || !numbers)
            return refuse("a usar:start_pose needs a name and x y z roll pitch yaw", element);
        if (std::ranges::find(world_.start_poses, *name, &NamedPose::name) != world_.start_poses.end())
            return refuse("there are two start poses named \"" + *name + "\"", element);
        const auto& [x, y, z, roll, pitch, yaw] = *numbers;
        world_.start_poses.push_back({*name, {{x, y, z}, roll, pitch, yaw}});
        return {};
    }

    Result<void> readRfidTag(sdf::Element& element) {
        const auto text = attributeOf(element, "id");
        const auto id = text ? readInteger(*text) : std::nullopt;
        const auto position_m = positionIn(element);
        if (!id || *id < 0 || *id > std::numeric_limits<int>::max() || !position_m)
            return refuse("a usar:rfid_tag needs a whole number from 0 up as its id, and x y z", element);
        const int tag_id = static_cast<int>(*id);
        if (std::ranges::find(world_.rfid_tags, tag_id, &RfidTag::id) != world_.rfid_tags.end())
            return refuse("there are two tags with the id " + std::to_string(tag_id), element);
        world_.rfid_tags.push_back({tag_id, attributeOf(element, "memory").value_or(""), *position_m});
        return {};
    }

    Result<void> readVictim(sdf::Element& element) {
        const auto name = attributeOf(element, "name");
        if (!name)
            return refuse("a usar:victim needs a name", element);
        Victim victim{*name, attributeOf(element, "status").value_or(""), {}};
        for (sdf::ElementPtr part = element.GetFirstElement(); part; part = part->GetNextElement()) {
            const auto kind = victimPartKind(attributeOf(*part, "kind").value_or(""));
            const auto position_m = positionIn(*part);
            if (part->GetName() != "usar:part" || !kind || !position_m)
                return refuse(
                    "the victim \"" + *name +
                        "\" is made of usar:part with a kind (Head, Arm, Hand, Chest, Pelvis, Leg, Foot) and x y z",
                    element);
            victim.parts.push_back({*kind, *position_m});
        }
        if (victim.parts.empty())
            return refuse("the victim \"" + *name + "\" has no usar:part, so nobody can find it", element);
        world_.victims.push_back(std::move(victim));
        return {};
    }

    Result<void> readSound(sdf::Element& element) {
        const auto name = attributeOf(element, "name");
        const auto loudness_db = numberOf(element, "loudness");
        const auto position_m = positionIn(element);
        if (!name || !loudness_db || !position_m)
            return refuse("a usar:sound needs a name, a loudness in dB, and x y z", element);
        world_.sounds.push_back({*name, *loudness_db, *position_m});
        return {};
    }

    Result<void> readGas(sdf::Element& element) {
        const auto gas = attributeOf(element, "gas");
        const auto density = numberOf(element, "density");
        const auto position_m = positionIn(element);
        if (!gas || !density || *density < 0.0 || !position_m)
            return refuse("a usar:gas needs a gas such as CO2, a density from 0 up, and x y z", element);
        world_.gases.push_back({*gas, *density, *position_m});
        return {};
    }

    Result<void> readGpsReference(sdf::Element& element) {
        const auto latitude_deg = numberOf(element, "latitude");
        const auto longitude_deg = numberOf(element, "longitude");
        if (!latitude_deg || !longitude_deg || std::abs(*latitude_deg) > 90.0 || std::abs(*longitude_deg) > 180.0)
            return refuse("a usar:gps_reference needs a latitude within +-90 and a longitude within +-180 degrees",
                          element);
        world_.gps_reference = {*latitude_deg, *longitude_deg};
        return {};
    }

    tl::unexpected<Error> refuse(const std::string& what, const sdf::Element& element) const {
        return refusal(what, file_, element);
    }

    std::filesystem::path file_;
    World world_;
};

} // namespace

Result<World> readWorld(const std::filesystem::path& folder) {
    const std::filesystem::path file = folder / "world.sdf";
    std::error_code trouble;
    if (!std::filesystem::is_directory(folder, trouble))
        return failure("there is no such world folder", folder.string(), "Check the name of the world");
    if (!std::filesystem::is_regular_file(file, trouble))
        return failure("the folder holds no world.sdf", folder.string(), "Check the name of the world");
    const auto root = loadSdf(file);
    if (!root)
        return tl::unexpected(root.error());
    if (root->WorldCount() != 1)
        return failure("there must be exactly one world in it", file.string(), fix_sdf);
    return WorldReading(file).read(*root->WorldByIndex(0));
}

} // namespace usar::sim
