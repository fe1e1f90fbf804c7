#include "core/sim/world/world_generator.h"

#include <algorithm>
#include <array>

#include "core/base/text.h"
#include "core/sim/world/world_writer.h"
#include "core/sim/worlds/made_worlds.h"

namespace usar::sim {

namespace {

using Folder = std::filesystem::path;

Result<World> volcanoFrom(std::uint64_t seed, const Folder& data) {
    return readElevationCsv(data / "volcano" / "volcano_10m.csv").map([&](const ElevationTable& source) {
        return makeVolcano(source, seed);
    });
}

template <World (*make)(std::uint64_t)>
Result<World> fromSeed(std::uint64_t seed, const Folder&) {
    return make(seed);
}

struct Generator {
    const char* name;
    Result<World> (*make)(std::uint64_t seed, const Folder& data);
};

constexpr std::array generators{Generator{"tall_test", fromSeed<makeTallTest>},
                                Generator{"vmac_room", fromSeed<makeVmacRoom>},
                                Generator{"point_lookout", fromSeed<makePointLookout>},
                                Generator{"spqr_soccer", fromSeed<makeSpqrSoccer>},
                                Generator{"volcano", volcanoFrom},
                                Generator{"warehouse", fromSeed<makeWarehouse>},
                                Generator{"town", fromSeed<makeTown>},
                                Generator{"quarry", fromSeed<makeQuarry>}};

} // namespace

std::vector<std::string> generatedWorldNames() {
    std::vector<std::string> names;
    for (const Generator& generator : generators)
        names.emplace_back(generator.name);
    return names;
}

Result<void> checkGenerator(const std::string& name) {
    if (std::ranges::find(generators, name, &Generator::name) != generators.end())
        return {};
    return failure("there is no generator for this world", name, "Known are: " + listOf(generators, &Generator::name));
}

Result<World> makeWorld(const std::string& name, std::uint64_t seed, const std::filesystem::path& data) {
    return checkGenerator(name).and_then(
        [&] { return std::ranges::find(generators, name, &Generator::name)->make(seed, data); });
}

Result<void> generateWorld(const std::string& name, std::uint64_t seed, const std::filesystem::path& data,
                           const std::filesystem::path& folder) {
    return makeWorld(name, seed, data).and_then([&](const World& world) { return writeWorld(world, folder); });
}

} // namespace usar::sim
