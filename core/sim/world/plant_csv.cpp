#include "core/sim/world/plant_csv.h"

#include <array>
#include <cmath>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/numbers.h"

namespace usar::sim {

namespace {

constexpr std::string_view heading = "kind,x,y,z,trunk_radius,trunk_height,crown_radius,crown_height";
constexpr std::size_t numbers = 7;

/// The plant that a line describes, or what is wrong with the line.
Result<Plant, std::string> readRow(std::string_view row) {
    std::array<double, numbers> values{};
    const std::size_t comma = row.find(',');
    const std::string_view kind = row.substr(0, comma);
    if (kind != "round" && kind != "cone")
        return tl::unexpected("the kind is \"" + std::string(kind) + "\", not round or cone");
    std::string_view rest = comma == std::string_view::npos ? std::string_view{} : row.substr(comma + 1);
    for (std::size_t i = 0; i < numbers; ++i) {
        const std::size_t end = rest.find(',');
        const std::string_view field = rest.substr(0, end);
        if ((end == std::string_view::npos) != (i + 1 == numbers))
            return tl::unexpected(std::string("there must be 8 columns"));
        const std::optional<double> value = readNumber(field);
        if (!value || !std::isfinite(*value))
            return tl::unexpected("\"" + std::string(field) + "\" is not a number");
        values[i] = *value;
        rest = end == std::string_view::npos ? std::string_view{} : rest.substr(end + 1);
    }
    Plant plant{.base_in_map_m = {values[0], values[1], values[2]},
                .trunk_radius_m = values[3],
                .trunk_height_m = values[4],
                .crown = kind == "cone" ? CrownShape::Cone : CrownShape::Sphere,
                .crown_radius_m = values[5],
                .crown_height_m = values[6]};
    for (std::size_t i = 3; i < numbers; ++i)
        if (values[i] < 0.0)
            return tl::unexpected(std::string("a radius or height is negative"));
    if (plant.crown == CrownShape::Cone && plant.crown_radius_m > 0.0 && plant.crown_height_m == 0.0)
        return tl::unexpected(std::string("a cone needs a crown height"));
    return plant;
}

} // namespace

Result<std::vector<Plant>> readPlantCsv(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    if (!in)
        return failure("the plants cannot be opened", file.string(), "Check the file's name and its permissions");
    std::vector<Plant> plants;
    std::string line;
    for (int number = 1; std::getline(in, line); ++number) {
        if (line.ends_with('\r'))
            line.pop_back();
        const std::string where = file.string() + ":" + std::to_string(number);
        if (number == 1 && line != heading)
            return failure("the heading line is wrong", where, "It must be " + std::string(heading));
        if (number == 1 || line.empty())
            continue;
        const auto plant = readRow(line);
        if (!plant)
            return failure(plant.error(), where, "Fix the line or generate the world again");
        plants.push_back(*plant);
    }
    return plants;
}

Result<void> writePlantCsv(const std::vector<Plant>& plants, const std::filesystem::path& file) {
    std::string text(heading);
    text += '\n';
    for (const Plant& plant : plants) {
        text += plant.crown == CrownShape::Cone ? "cone" : "round";
        for (const double value :
             {plant.base_in_map_m.x(), plant.base_in_map_m.y(), plant.base_in_map_m.z(), plant.trunk_radius_m,
              plant.trunk_height_m, plant.crown_radius_m, plant.crown_height_m}) {
            text += ',';
            appendShortest(text, value);
        }
        text += '\n';
    }
    std::ofstream out(file, std::ios::binary);
    out << text;
    out.close();
    if (!out)
        return failure("the plants cannot be written", file.string(),
                       "Is the disk full or the folder write-protected?");
    return {};
}

} // namespace usar::sim
