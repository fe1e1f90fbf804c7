// Strengths between the radios of a simulation, by the names that robots bear on the wire.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/sim/simulation.h"

namespace usar::link {

/// Remembers what it was asked until the world moves, so that many questions cost little. In the simulator's thread;
/// the simulation must outlive every call.
class RadioField {
public:
    explicit RadioField(const sim::Simulation& simulation) : simulation_(simulation) {}

    /// The world has moved.
    void forget();
    /// Of the first robot or base station with that name; nothing where there is none, or its battery is empty.
    const sim::RadioStation* station(const std::string& name);
    const std::vector<sim::RadioStation>& stations();
    /// Nothing where one of the two cannot be heard.
    std::optional<double> strength_dbm(const std::string& a, const std::string& b);
    /// Strong enough for a link.
    bool reaches(const std::string& a, const std::string& b);

private:
    const sim::Simulation& simulation_;
    std::optional<std::vector<sim::RadioStation>> stations_;
    std::map<std::pair<std::string, std::string>, std::optional<double>> strengths_dbm_;
};

} // namespace usar::link
