// A P2DX and an ERS that see and push each other, driven the same way each time.
#pragma once

#include <string>

#include "tests/sim/talker.h"
#include "tests/sim/tiny_worlds.h"

namespace usar::sim {

/// All that both hear in so many ticks.
inline std::string heardByTwoRobots(std::uint64_t seed, int ticks) {
    SimulationOptions options;
    options.seed = seed;
    options.battery_life = Seconds{1e5};
    const auto simulation = simulationOf(flatWorld(), options);
    const ClientId ers = simulation->connect();
    simulation->receive(ers, "INIT {ClassName ERS} {Location 1,0.5,-0.3}\r\n");
    std::string heard = heardBy(*simulation, init_p2dx, ticks, [&](int tick) {
        simulation->receive(ers, "MULTIDRIVE {LFLeg1 " + std::to_string(0.1 * (tick % 5)) + "}\r\n");
    });
    return heard + simulation->takeOutput(ers);
}

} // namespace usar::sim
