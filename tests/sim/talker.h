// A client of a Simulation without sockets: says lines, reads lines.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/protocol/line_splitter.h"
#include "core/protocol/reader.h"
#include "core/sim/simulation.h"

namespace usar::sim {

std::unique_ptr<Simulation> simulationOf(World world, SimulationOptions options = {});

/// Simulates this many message ticks.
inline void steps(Simulation& simulation, int count) {
    for (int i = 0; i < count; ++i)
        simulation.step();
}

class Talker {
public:
    explicit Talker(Simulation& simulation) : simulation_(simulation), id_(simulation.connect()) {}

    void say(const std::string& line) { simulation_.receive(id_, line + "\r\n"); }
    /// Everything since the last call, as text lines and as values.
    std::vector<std::string> hearText();
    std::vector<protocol::InfoLine> hear();
    /// The last message of a kind among those that `hear` would give; the rest is forgotten.
    template <class Message>
    std::optional<Message> hearLast();
    ClientId id() const { return id_; }

private:
    Simulation& simulation_;
    ClientId id_;
    protocol::LineSplitter splitter_;
    protocol::Reader reader_;
};

inline constexpr const char* init_p2dx = "INIT {ClassName USARBot.P2DX} {Name R1} {Location 0,0,-0.2}";

/// What one client hears in `ticks` while it drives about; `meanwhile` may do anything to the simulation each tick.
std::string heardBy(Simulation& simulation, const char* init, int ticks,
                    const std::function<void(int tick)>& meanwhile = {});

/// "SEN Sonar", "STA": the type word and the type of a sensor.
std::string kindOf(const std::string& line);
std::vector<std::string> kindsOf(const std::vector<std::string>& lines);

template <class Message>
std::optional<Message> Talker::hearLast() {
    std::optional<Message> last;
    for (const protocol::InfoLine& line : hear())
        if (const auto* const message = std::get_if<Message>(&line.message))
            last = *message;
    return last;
}

} // namespace usar::sim
