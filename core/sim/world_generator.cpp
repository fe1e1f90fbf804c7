#include "core/sim/world_generator.h"

#include "core/sim/world_writer.h"
#include "core/sim/worlds/tall_test.h"

namespace usar::sim {

std::vector<std::string> generatedWorldNames() {
    return {"tall_test"};
}

Result<void> generateWorld(const std::string& name, std::uint64_t seed, const std::filesystem::path& folder) {
    if (name == "tall_test")
        return writeWorld(makeTallTest(seed), folder);
    std::string known;
    for (const std::string& each : generatedWorldNames())
        known += (known.empty() ? "" : ", ") + each;
    return failure("there is no generator for this world", name, "Known are: " + known);
}

} // namespace usar::sim
