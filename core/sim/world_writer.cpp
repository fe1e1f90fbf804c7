#include "core/sim/world_writer.h"

#include <cmath>
#include <fstream>
#include <string>
#include <string_view>

#include "core/base/numbers.h"
#include "core/sim/height_png.h"
#include "core/sim/plant_csv.h"

namespace usar::sim {

namespace {

constexpr double steps_per_m = 1024.0;
constexpr double highest_value = 65535.0;

std::string escaped(std::string_view text) {
    std::string safe;
    for (const char c : text)
        switch (c) {
        case '&':
            safe += "&amp;";
            break;
        case '<':
            safe += "&lt;";
            break;
        case '>':
            safe += "&gt;";
            break;
        case '"':
            safe += "&quot;";
            break;
        default:
            safe += c;
        }
    return safe;
}

template <class... Numbers>
std::string spaced(Numbers... values) {
    std::string text;
    for (const double value : {static_cast<double>(values)...}) {
        if (!text.empty())
            text += ' ';
        appendShortest(text, value);
    }
    return text;
}

std::string poseText(const Pose& pose) {
    return spaced(pose.position_m.x(), pose.position_m.y(), pose.position_m.z(), pose.roll_rad, pose.pitch_rad,
                  pose.yaw_rad);
}

double datum_m(const Terrain& terrain) {
    return std::floor(static_cast<double>(terrain.minimum_m()));
}

HeightImage heightImage(const Terrain& terrain) {
    HeightImage image{.columns = terrain.columns(), .rows = terrain.rows(), .values = {}};
    image.values.reserve(image.columns * image.rows);
    for (std::size_t row = terrain.rows(); row-- > 0;)
        for (std::size_t column = 0; column < terrain.columns(); ++column) {
            const double above_m = static_cast<double>(terrain.post_m(column, row)) - datum_m(terrain);
            image.values.push_back(static_cast<std::uint16_t>(std::lround(above_m * steps_per_m)));
        }
    return image;
}

std::string staticModel(const std::string& name, const std::string& pose, const std::string& content) {
    return "    <model name=\"" + name + "\">\n      <static>true</static>\n" + pose + content + "    </model>\n";
}

std::string shape(const std::string& geometry) {
    std::string text = "      <link name=\"link\">\n";
    for (const std::string tag : {"collision", "visual"})
        text += "        <" + tag + " name=\"" + tag + "\"><geometry>" + geometry + "</geometry></" + tag + ">\n";
    return text + "      </link>\n";
}

std::string groundModel(const Terrain& terrain) {
    const Rectangle extent = terrain.extent();
    const Vec2 center_m = extent.center_m();
    const std::string size = spaced(extent.width_m(), extent.height_m(), highest_value / steps_per_m);
    const std::string position = spaced(center_m.x(), center_m.y(), datum_m(terrain));
    return staticModel(
        "ground", "",
        shape("<heightmap><uri>height.png</uri><size>" + size + "</size><pos>" + position + "</pos></heightmap>"));
}

std::string boxModel(const Box& box, std::size_t number) {
    const std::string size = spaced(box.size_m.x(), box.size_m.y(), box.size_m.z());
    return staticModel("box_" + std::to_string(number), "      <pose>" + poseText(box.center_in_map) + "</pose>\n",
                       shape("<box><size>" + size + "</size></box>"));
}

std::string sdfText(const World& world) {
    std::string text = "<?xml version=\"1.0\"?>\n"
                       "<sdf version=\"1.9\" xmlns:usar=\"urn:usar-mission-control:world\">\n"
                       "  <world name=\"" +
                       escaped(world.name) + "\">\n" + groundModel(world.terrain);
    for (std::size_t i = 0; i < world.boxes.size(); ++i)
        text += boxModel(world.boxes[i], i + 1);
    text += "    <usar:scatter><usar:uri>plants.csv</usar:uri></usar:scatter>\n";
    if (world.water)
        text += "    <usar:water><usar:surface_z>" + spaced(world.water->surface_z_m) +
                "</usar:surface_z><usar:density>" + spaced(world.water->density_kg_m3) +
                "</usar:density></usar:water>\n";
    for (const NamedPose& start : world.start_poses)
        text += "    <usar:start_pose name=\"" + escaped(start.name) + "\">" + poseText(start.pose_in_map) +
                "</usar:start_pose>\n";
    return text + "  </world>\n</sdf>\n";
}

} // namespace

Result<void> writeWorld(const World& world, const std::filesystem::path& folder) {
    if (world.terrain.empty() ||
        static_cast<double>(world.terrain.maximum_m()) - datum_m(world.terrain) > highest_value / steps_per_m)
        return failure("this terrain has no height map: it is empty or its relief exceeds 63 m", folder.string());
    std::error_code trouble;
    std::filesystem::create_directories(folder, trouble);
    if (trouble)
        return failure("the world's folder cannot be made: " + trouble.message(), folder.string(),
                       "Choose a folder that can be written to");
    if (auto written = writeHeightPng(heightImage(world.terrain), folder / "height.png"); !written)
        return written;
    if (auto written = writePlantCsv(world.plants, folder / "plants.csv"); !written)
        return written;
    std::ofstream out(folder / "world.sdf", std::ios::binary);
    out << sdfText(world);
    out.close();
    if (!out)
        return failure("the world cannot be written", (folder / "world.sdf").string(), "Is the disk full?");
    return {};
}

} // namespace usar::sim
