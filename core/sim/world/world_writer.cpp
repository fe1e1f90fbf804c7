#include "core/sim/world/world_writer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <string>
#include <string_view>
#include <variant>

#include "core/base/numbers.h"
#include "core/sim/world/height_png.h"
#include "core/sim/world/plant_csv.h"

namespace usar::sim {

namespace {

/// Maps heights to the values of a 16-bit picture: value = (height - datum) / step.
struct HeightScale {
    double datum_m = 0.0;
    double step_m = 0.0; ///< 0 if the ground needs no picture
};

constexpr double highest_picture_value = 65535.0; ///< of a 16-bit picture

std::string escaped(std::string_view text) {
    constexpr std::string_view special = "&<>\"";
    constexpr std::array names{"&amp;", "&lt;", "&gt;", "&quot;"};
    std::string safe;
    for (const char c : text)
        if (const std::size_t at = special.find(c); at != std::string_view::npos)
            safe += names[at];
        else
            safe += c;
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

std::string spaced(const Vec3& values) {
    return spaced(values.x(), values.y(), values.z());
}

std::string poseText(const Pose& pose) {
    return spaced(pose.position_m) + " " + spaced(pose.roll_rad, pose.pitch_rad, pose.yaw_rad);
}

std::string staticModel(const std::string& name, const std::string& pose, const std::string& content) {
    return "    <model name=\"" + name + "\">\n      <static>true</static>\n" + pose + content + "    </model>\n";
}

std::string poseLine(const std::string& pose) {
    return "      <pose>" + pose + "</pose>\n";
}

std::string shape(const std::string& geometry) {
    std::string text = "      <link name=\"link\">\n";
    for (const std::string tag : {"collision", "visual"})
        text += "        <" + tag + " name=\"" + tag + "\"><geometry>" + geometry + "</geometry></" + tag + ">\n";
    return text + "      </link>\n";
}

std::string groundModel(const Terrain& terrain, const HeightScale& scale) {
    const Rectangle extent = terrain.extent();
    const Vec2 center_m = extent.center_m();
    const std::string sides = spaced(extent.width_m(), extent.height_m());
    if (scale.step_m == 0.0)
        return staticModel("ground", poseLine(spaced(center_m.x(), center_m.y(), terrain.minimum_m()) + " 0 0 0"),
                           shape("<plane><normal>0 0 1</normal><size>" + sides + "</size></plane>"));
    const std::string size = sides + " " + spaced(highest_picture_value * scale.step_m);
    const std::string position = spaced(center_m.x(), center_m.y(), scale.datum_m);
    return staticModel(
        "ground", "",
        shape("<heightmap><uri>height.png</uri><size>" + size + "</size><pos>" + position + "</pos></heightmap>"));
}

std::string tag(const std::string& name, const std::string& content) {
    return "<" + name + ">" + content + "</" + name + ">";
}

/// Collision and visual of one shape in a link.
std::string placedShape(std::size_t number, const std::string& pose, const std::string& geometry,
                        const std::string& surface) {
    const std::string name = "_" + std::to_string(number) + "\">";
    const std::string placed = tag("pose", pose) + tag("geometry", geometry);
    return "        <collision name=\"collision" + name + placed + surface + "</collision>\n" +
           "        <visual name=\"visual" + name + placed + "</visual>\n";
}

/// Puts all boxes into one model: libsdformat takes 7 ms for each model of a world, and hardly any time for a shape in
/// a link.
std::string buildings(const std::vector<Box>& boxes) {
    std::string shapes;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        const Vec3& size_m = boxes[i].size_m;
        shapes += placedShape(i + 1, poseText(boxes[i].center_in_map), tag("box", tag("size", spaced(size_m))), "");
    }
    return staticModel("buildings", "", "      <link name=\"link\">\n" + shapes + "      </link>\n");
}

struct GeometryText {
    std::string operator()(const BoxShape& box) const { return tag("box", tag("size", spaced(box.size_m))); }
    std::string operator()(const SphereShape& ball) const {
        return tag("sphere", tag("radius", spaced(ball.radius_m)));
    }
    std::string operator()(const CylinderShape& rod) const {
        return tag("cylinder", sizes(rod.radius_m, rod.height_m));
    }
    std::string operator()(const CapsuleShape& rod) const { return tag("capsule", sizes(rod.radius_m, rod.height_m)); }

    static std::string sizes(double radius_m, double length_m) {
        return tag("radius", spaced(radius_m)) + tag("length", spaced(length_m));
    }
};

std::string inertialText(const BodyDescription& body) {
    const Vec3& inertia = body.inertia_kg_m2;
    return "        " +
           tag("inertial", tag("mass", spaced(body.mass_kg)) +
                               tag("inertia", tag("ixx", spaced(inertia.x())) + tag("iyy", spaced(inertia.y())) +
                                                  tag("izz", spaced(inertia.z())))) +
           "\n";
}

std::string objectModel(const WorldObject& object) {
    const BodyDescription& body = object.body;
    const std::string surface = tag(
        "surface", tag("bounce", tag("restitution_coefficient", spaced(body.restitution))) +
                       tag("friction", tag("bullet", tag("friction", spaced(body.friction)) +
                                                         tag("rolling_friction", spaced(body.rolling_friction_m)))));
    std::string text = "    <model name=\"" + escaped(object.name) + "\">\n" + poseLine(poseText(object.body_in_map));
    if (!object.class_name.empty())
        text += "      " + tag("usar:class_name", escaped(object.class_name)) + "\n";
    text += "      <link name=\"link\">\n" + inertialText(body);
    for (std::size_t i = 0; i < body.parts.size(); ++i)
        text += placedShape(i + 1, poseText(body.parts[i].part_in_body),
                            std::visit(GeometryText{}, body.parts[i].shape), surface);
    return text + "      </link>\n    </model>\n";
}

/// Makes <usar:NAME ATTRIBUTES>content</usar:NAME> on a line of its own.
std::string mark(const std::string& name, const std::string& attributes, const std::string& content) {
    return "    <usar:" + name + attributes + ">" + content + "</usar:" + name + ">\n";
}

std::string attribute(const std::string& name, std::string_view value) {
    return " " + name + "=\"" + escaped(value) + "\"";
}

std::string victimMark(const Victim& victim) {
    std::string parts = "\n";
    for (const VictimPart& part : victim.parts)
        parts += "  " + mark("part", attribute("kind", nameOf(part.kind)), spaced(part.position_in_map_m));
    return mark("victim", attribute("name", victim.name) + attribute("status", victim.status), parts + "    ");
}

std::string sensorMarks(const World& world) {
    std::string text;
    for (const RfidTag& tag : world.rfid_tags)
        text += mark("rfid_tag", attribute("id", std::to_string(tag.id)) + attribute("memory", tag.memory),
                     spaced(tag.position_in_map_m));
    for (const Victim& victim : world.victims)
        text += victimMark(victim);
    for (const SoundSource& sound : world.sounds)
        text += mark("sound", attribute("name", sound.name) + attribute("loudness", spaced(sound.loudness_db)),
                     spaced(sound.position_in_map_m));
    for (const GasSource& gas : world.gases)
        text += mark("gas", attribute("gas", gas.gas) + attribute("density", spaced(gas.density)),
                     spaced(gas.position_in_map_m));
    if (world.gps_reference != GpsReference{})
        text += mark("gps_reference",
                     attribute("latitude", spaced(world.gps_reference.latitude_deg)) +
                         attribute("longitude", spaced(world.gps_reference.longitude_deg)),
                     "");
    return text;
}

/// Returns the whole world.sdf. It refers to height.png if `scale` has a step, and to plants.csv if there are plants.
std::string sdfText(const World& world, const HeightScale& scale) {
    std::string text = "<?xml version=\"1.0\"?>\n"
                       "<sdf version=\"1.9\" xmlns:usar=\"urn:usar-mission-control:world\">\n"
                       "  <world name=\"" +
                       escaped(world.name) + "\">\n";
    if (!world.terrain.empty())
        text += groundModel(world.terrain, scale);
    if (!world.boxes.empty())
        text += buildings(world.boxes);
    for (const WorldObject& object : world.objects)
        text += objectModel(object);
    if (!world.plants.empty())
        text += mark("scatter", "", "<usar:uri>plants.csv</usar:uri>");
    if (world.water)
        text += mark("water", "",
                     tag("usar:surface_z", spaced(world.water->surface_z_m)) +
                         tag("usar:density", spaced(world.water->density_kg_m3)));
    for (const NamedPose& start : world.start_poses)
        text += mark("start_pose", attribute("name", start.name), poseText(start.pose_in_map));
    return text + sensorMarks(world) + "  </world>\n</sdf>\n";
}

bool isLevelFloor(const Terrain& terrain) {
    return terrain.minimum_m() == terrain.maximum_m() &&
           Terrain::level(terrain.extent(), terrain.minimum_m()) == terrain;
}

/// The finest scale that covers the relief; a step of 0 if there is none.
HeightScale scaleFor(const Terrain& terrain) {
    if (terrain.empty() || isLevelFloor(terrain))
        return {};
    HeightScale scale{.datum_m = std::floor(static_cast<double>(terrain.minimum_m())), .step_m = finest_height_step_m};
    while (static_cast<double>(terrain.maximum_m()) - scale.datum_m > highest_picture_value * scale.step_m)
        scale.step_m *= 2.0;
    return scale;
}

HeightImage heightImage(const Terrain& terrain, const HeightScale& scale) {
    HeightImage image{.columns = terrain.columns(), .rows = terrain.rows(), .values = {}};
    image.values.reserve(image.columns * image.rows);
    for (std::size_t row = terrain.rows(); row-- > 0;)
        for (std::size_t column = 0; column < terrain.columns(); ++column) {
            const double above_m = static_cast<double>(terrain.post_m(column, row)) - scale.datum_m;
            image.values.push_back(static_cast<std::uint16_t>(std::lround(above_m / scale.step_m)));
        }
    return image;
}

bool isFinite(const Terrain& terrain) {
    return std::all_of(terrain.heights_m().begin(), terrain.heights_m().end(),
                       [](float height_m) { return std::isfinite(height_m); });
}

} // namespace

Result<void> writeWorld(const World& world, const std::filesystem::path& folder) {
    if (world.terrain.empty() && world.boxes.empty())
        return failure("this world has nothing to stand on, so it cannot be written", folder.string());
    if (!isFinite(world.terrain))
        return failure("this terrain has a height that is not a number", folder.string());
    std::error_code trouble;
    std::filesystem::create_directories(folder, trouble);
    if (trouble)
        return failure("the world's folder cannot be made: " + trouble.message(), folder.string(),
                       "Choose a folder that can be written to");
    const HeightScale scale = scaleFor(world.terrain);
    if (scale.step_m > 0.0)
        if (auto written = writeHeightPng(heightImage(world.terrain, scale), folder / "height.png"); !written)
            return written;
    if (!world.plants.empty())
        if (auto written = writePlantCsv(world.plants, folder / "plants.csv"); !written)
            return written;
    std::ofstream out(folder / "world.sdf", std::ios::binary);
    out << sdfText(world, scale);
    out.close();
    if (!out)
        return failure("the world cannot be written", (folder / "world.sdf").string(), "Is the disk full?");
    return {};
}

} // namespace usar::sim
