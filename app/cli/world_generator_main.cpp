// usar-make-world NAME SEED FOLDER: writes one of the worlds that come with the program. It is run during the build.
#include <cstdio>
#include <string>
#include <vector>

#include "core/base/numbers.h"
#include "core/base/version.h"
#include "core/sim/world/world_generator.h"

int main(int argc, char** argv) {
    if (usar::answersVersion(argc, argv))
        return 0;
    const std::vector<std::string> arguments(argv + 1, argv + argc);
    const auto seed = arguments.size() == 3 ? usar::readInteger(arguments[1]) : std::nullopt;
    if (!seed || *seed < 0) {
        std::fprintf(stderr, "usage: usar-make-world NAME SEED FOLDER\nworlds:");
        for (const std::string& name : usar::sim::generatedWorldNames())
            std::fprintf(stderr, " %s", name.c_str());
        std::fprintf(stderr, "\n");
        return 2;
    }
    const auto done =
        usar::sim::generateWorld(arguments[0], static_cast<std::uint64_t>(*seed), USAR_WORLD_DATA, arguments[2]);
    if (!done) {
        std::fprintf(stderr, "%s\n", done.error().text().c_str());
        return 1;
    }
    return 0;
}
