#include "core/sim/world_reader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <system_error>

#include <sdf/sdf.hh>

#include "core/base/numbers.h"
#include "core/sim/height_png.h"
#include "core/sim/plant_csv.h"
#include "core/sim/sdf_loader.h"

namespace usar::sim {

namespace {

constexpr const char* regenerate = "Mend the file or generate the world again";

Pose toPose(const ignition::math::Pose3d& pose) {
    const ignition::math::Vector3d angles_rad = pose.Rot().Euler();
    return {{pose.Pos().X(), pose.Pos().Y(), pose.Pos().Z()}, angles_rad.X(), angles_rad.Y(), angles_rad.Z()};
}

/// `count` numbers with blanks between them, and nothing else.
template <std::size_t count>
std::optional<std::array<double, count>> readList(std::string_view text) {
    constexpr std::string_view blanks = " \t\r\n";
    std::array<double, count> values{};
    std::size_t at = 0;
    for (double& value : values) {
        at = text.find_first_not_of(blanks, at);
        if (at == std::string_view::npos)
            return std::nullopt;
        const std::size_t end = std::min(text.find_first_of(blanks, at), text.size());
        const auto number = readNumber(text.substr(at, end - at));
        if (!number || !std::isfinite(*number))
            return std::nullopt;
        value = *number;
        at = end;
    }
    return text.find_first_not_of(blanks, at) == std::string_view::npos ? std::optional(values) : std::nullopt;
}

/// Fills a world from the elements of one file.
class Reading {
public:
    explicit Reading(const std::filesystem::path& file) : file_(file) {}

    Result<World> read(const sdf::World& source);

private:
    Result<void> readModel(const sdf::Model& model);
    Result<void> readCollision(const sdf::Model& model, const sdf::Link& link, const sdf::Collision& collision);
    Result<void> readHeightmap(const sdf::Heightmap& heightmap, const Pose& collision_in_map);
    Result<void> readOurElement(sdf::Element& element);
    Result<void> readStartPose(const sdf::Element& element);
    Result<void> readWater(sdf::Element& element);
    tl::unexpected<Error> refuse(const std::string& what) const { return failure(what, file_.string(), regenerate); }
    std::filesystem::path besides(const std::string& uri) const { return file_.parent_path() / uri; }

    std::filesystem::path file_;
    World world_;
};

Result<void> Reading::readHeightmap(const sdf::Heightmap& heightmap, const Pose& collision_in_map) {
    if (!world_.terrain.empty())
        return refuse("the world has two height maps, but one ground");
    auto image = readHeightPng(besides(heightmap.Uri()));
    if (!image)
        return tl::unexpected(image.error());
    const auto side = [](std::size_t posts) { return static_cast<double>(posts - 1); };
    const ignition::math::Vector3d& size_m = heightmap.Size();
    if (image->columns < 2 || image->rows < 2)
        return refuse("the height map has less than 2 x 2 posts");
    const double step_m = size_m.X() / side(image->columns);
    if (!(step_m > 0.0) || std::abs(size_m.Y() / side(image->rows) - step_m) > 1e-9 * step_m || !(size_m.Z() >= 0.0))
        return refuse("the size of the height map does not fit its picture of " + std::to_string(image->columns) +
                      " x " + std::to_string(image->rows) + " posts: posts must be equally far apart in x and y");
    const Vec3 center_m = collision_in_map.position_m +
                          Vec3{heightmap.Position().X(), heightmap.Position().Y(), heightmap.Position().Z()};
    std::vector<float> heights_m(image->values.size());
    for (std::size_t row = 0; row < image->rows; ++row)
        for (std::size_t column = 0; column < image->columns; ++column)
            heights_m[(image->rows - 1 - row) * image->columns + column] =
                static_cast<float>(center_m.z() + size_m.Z() * image->values[row * image->columns + column] / 65535.0);
    world_.terrain = Terrain(image->columns, image->rows, step_m,
                             center_m.head<2>() - Vec2{size_m.X(), size_m.Y()} / 2.0, std::move(heights_m));
    return {};
}

Result<void> Reading::readCollision(const sdf::Model& model, const sdf::Link& link, const sdf::Collision& collision) {
    const Pose collision_in_map = toPose(model.RawPose()) * (toPose(link.RawPose()) * toPose(collision.RawPose()));
    if (collision.Geom()->Type() == sdf::GeometryType::HEIGHTMAP)
        return readHeightmap(*collision.Geom()->HeightmapShape(), collision_in_map);
    if (collision.Geom()->Type() != sdf::GeometryType::BOX)
        return refuse("model \"" + model.Name() + "\" has a shape that is neither a box nor a height map");
    const ignition::math::Vector3d size_m = collision.Geom()->BoxShape()->Size();
    world_.boxes.push_back({collision_in_map, {size_m.X(), size_m.Y(), size_m.Z()}});
    return {};
}

Result<void> Reading::readModel(const sdf::Model& model) {
    for (uint64_t l = 0; l < model.LinkCount(); ++l) {
        const sdf::Link& link = *model.LinkByIndex(l);
        for (uint64_t c = 0; c < link.CollisionCount(); ++c)
            if (auto done = readCollision(model, link, *link.CollisionByIndex(c)); !done)
                return done;
    }
    return {};
}

Result<void> Reading::readStartPose(const sdf::Element& element) {
    const auto name = element.GetAttribute("name");
    const auto value = element.GetValue();
    const auto numbers = value ? readList<6>(value->GetAsString()) : std::nullopt;
    if (!name || name->GetAsString().empty() || !numbers)
        return refuse("a usar:start_pose needs a name and x y z roll pitch yaw");
    const auto& [x, y, z, roll, pitch, yaw] = *numbers;
    world_.start_poses.push_back({name->GetAsString(), {{x, y, z}, roll, pitch, yaw}});
    return {};
}

Result<void> Reading::readWater(sdf::Element& element) {
    const auto number = [&](const std::string& name) -> std::optional<double> {
        return element.HasElement(name) ? readNumber(element.GetElement(name)->Get<std::string>()) : std::nullopt;
    };
    const auto surface_z_m = number("usar:surface_z");
    const auto density_kg_m3 = number("usar:density");
    if (!surface_z_m || !density_kg_m3 || !(*density_kg_m3 > 0.0))
        return refuse("a usar:water needs a usar:surface_z and a usar:density above zero");
    world_.water = Water{*surface_z_m, *density_kg_m3};
    return {};
}

Result<void> Reading::readOurElement(sdf::Element& element) {
    if (element.GetName() == "usar:start_pose")
        return readStartPose(element);
    if (element.GetName() == "usar:water")
        return readWater(element);
    if (element.GetName() != "usar:scatter")
        return {};
    if (!element.HasElement("usar:uri"))
        return refuse("a usar:scatter needs a usar:uri");
    auto plants = readPlantCsv(besides(element.GetElement("usar:uri")->Get<std::string>()));
    if (!plants)
        return tl::unexpected(plants.error());
    world_.plants.insert(world_.plants.end(), plants->begin(), plants->end());
    return {};
}

Result<World> Reading::read(const sdf::World& source) {
    world_.name = source.Name();
    for (uint64_t i = 0; i < source.ModelCount(); ++i)
        if (auto done = readModel(*source.ModelByIndex(i)); !done)
            return tl::unexpected(done.error());
    for (sdf::ElementPtr element = source.Element()->GetFirstElement(); element; element = element->GetNextElement())
        if (auto done = readOurElement(*element); !done)
            return tl::unexpected(done.error());
    if (world_.terrain.empty())
        return refuse("the world has no ground: no collision with a height map");
    if (world_.start_poses.empty())
        return refuse("the world has no usar:start_pose, so no robot could begin");
    return std::move(world_);
}

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
        return failure("there must be exactly one world in it", file.string(), regenerate);
    return Reading(file).read(*root->WorldByIndex(0));
}

} // namespace usar::sim
