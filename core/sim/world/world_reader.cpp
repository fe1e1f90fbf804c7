#include "core/sim/world/world_reader.h"

#include <cmath>
#include <string>
#include <system_error>

#include <sdf/sdf.hh>

#include "core/sim/world/height_png.h"
#include "core/sim/world/sdf_fields.h"
#include "core/sim/world/world_marks_reader.h"
#include "core/sim/world/world_object_reader.h"

namespace usar::sim {

namespace {

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
            if (auto done = readMark(*element, file_, world_); !done)
                return tl::unexpected(done.error());
        if (world_.terrain.empty() && world_.boxes.empty())
            return refuse("the world has no ground: no collision with a height map, a plane or a box",
                          source.Element());
        if (world_.start_poses.empty())
            return refuse("the world has no usar:start_pose, so no robot can start", source.Element());
        return std::move(world_);
    }

private:
    Result<void> readModel(const sdf::Model& model) {
        if (!model.Static()) {
            auto object = readObject(model, file_);
            if (!object)
                return tl::unexpected(object.error());
            world_.objects.push_back(*std::move(object));
            return {};
        }
        if (model.ModelCount() != 0)
            return refuse("model \"" + model.Name() + "\" has models in it: give each a place in the world",
                          model.Element());
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
                return refuse("model \"" + model.Name() + "\" has a box without size", collision.Element());
            world_.boxes.push_back({collision_in_map, toVec3(collision.Geom()->BoxShape()->Size())});
            return {};
        default:
            return refuse("model \"" + model.Name() +
                              "\" has a shape that is neither a box nor a plane nor a height map",
                          collision.Element());
        }
    }

    Result<void> readHeightmap(const sdf::Heightmap& heightmap, const Pose& collision_in_map) {
        if (!world_.terrain.empty())
            return refuse(two_grounds, heightmap.Element());
        auto image = readHeightPng(file_.parent_path() / heightmap.Uri());
        if (!image)
            return tl::unexpected(image.error());
        const auto side = [](std::size_t posts) { return static_cast<double>(posts - 1); };
        const ignition::math::Vector3d& size_m = heightmap.Size();
        if (image->columns < 2 || image->rows < 2)
            return refuse("the height map has fewer than 2 x 2 posts", heightmap.Element());
        const double step_m = size_m.X() / side(image->columns);
        if (!(step_m > 0.0) || std::abs(size_m.Y() / side(image->rows) - step_m) > 1e-9 * step_m ||
            !(size_m.Z() >= 0.0))
            return refuse("the size of the height map does not fit its picture of " + std::to_string(image->columns) +
                              " x " + std::to_string(image->rows) +
                              " posts: posts must be equally far apart in x and y",
                          heightmap.Element());
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
            return refuse(two_grounds, plane.Element());
        const Vec3 up = collision_in_map.rotation() * toVec3(plane.Normal());
        if (up.z() < 1.0 - 1e-9 || collision_in_map.yaw_rad != 0.0)
            return refuse("a plane is a floor: it must lie level and along x and y", plane.Element());
        const Vec2 half_m = Vec2(plane.Size().X(), plane.Size().Y()) / 2.0;
        const Vec2 center_m = collision_in_map.position_m.head<2>();
        auto floor = Terrain::level({center_m - half_m, center_m + half_m}, collision_in_map.position_m.z());
        if (!floor)
            return refuse(
                "the sides of the plane need a common measure that is not too small, such as 1 m or 0.1 m, above zero",
                plane.Element());
        world_.terrain = *std::move(floor);
        return {};
    }

    tl::unexpected<Error> refuse(const std::string& what, const sdf::ElementPtr& element) const {
        return refusal(what, file_, *element);
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
