#include "tests/sim/talker.h"

#include <stdexcept>

#include "core/base/diagnostics.h"
#include "core/protocol/segments.h"
#include "tests/doubles/shipped_robots.h"

namespace usar::sim {

std::unique_ptr<Simulation> simulationOf(World world, SimulationOptions options) {
    if (!options.robots)
        options.robots = doubles::shippedRobots();
    auto made = Simulation::make(std::move(world), options);
    if (!made)
        throw std::runtime_error(made.error().text());
    return std::move(*made);
}

std::vector<std::string> Talker::hearText() {
    std::vector<std::string> lines;
    splitter_.feed(simulation_.takeOutput(id_), [&](std::string_view line) { lines.emplace_back(line); });
    return lines;
}

std::vector<protocol::InfoLine> Talker::hear() {
    std::vector<protocol::InfoLine> lines;
    for (const std::string& line : hearText())
        lines.push_back(reader_.read(line));
    return lines;
}

std::string heardBy(Simulation& simulation, const char* init, int ticks,
                    const std::function<void(int tick)>& meanwhile) {
    const ClientId client = simulation.connect();
    simulation.receive(client, std::string(init) + "\r\n");
    std::string heard;
    for (int tick = 0; tick < ticks; ++tick) {
        if (tick % 10 == 5)
            simulation.receive(client, "DRIVE {Left " + std::to_string(tick % 7) + "} {Right 3}\r\n");
        if (meanwhile)
            meanwhile(tick);
        simulation.step();
        heard += simulation.takeOutput(client);
    }
    return heard;
}

std::string kindOf(const std::string& line) {
    Diagnostics diagnostics;
    protocol::Segments segments;
    segments.read(line, diagnostics);
    const std::string word(segments.typeWord());
    return word == "SEN" ? word + " " + std::string(segments.value("Type")) : word;
}

std::vector<std::string> kindsOf(const std::vector<std::string>& lines) {
    std::vector<std::string> kinds;
    for (const std::string& line : lines)
        kinds.push_back(kindOf(line));
    return kinds;
}

} // namespace usar::sim
