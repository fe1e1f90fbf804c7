#include "core/sim/world/world_writer.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>

#include "core/sim/world/height_png.h"
#include "core/sim/world/plant_csv.h"
#include "core/sim/world/world_sdf_text.h"

namespace usar::sim {

namespace {

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
