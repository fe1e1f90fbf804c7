// Signal strengths between the radios of a simulation, by the names that the robots have on the wire.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/sim/simulation.h"

namespace usar::server {

/// Caches its answers until the world moves, so that many questions are cheap. To be used in the simulator's thread;
/// the simulation must outlive it.
class RadioField {
public:
    explicit RadioField(const sim::Simulation& simulation) : simulation_(simulation) {}

    /// Drops all cached answers. To be called when the world has moved.
    void forget();
    /// First robot or base station with that name; null if there is none or its battery is empty. Valid until forget().
    const sim::RadioStation* station(const std::string& name);
    /// All robots and base stations, including those with an empty battery. Valid until forget().
    const std::vector<sim::RadioStation>& stations();
    /// Signal strength between two stations; nullopt if either is missing or has an empty battery.
    std::optional<double> strength_dbm(const std::string& a, const std::string& b);
    /// Whether the signal between the two is strong enough for a link, that is, at least the radio's `cutoff_dbm`.
    bool reaches(const std::string& a, const std::string& b);

private:
    const sim::Simulation& simulation_;
    std::optional<std::vector<sim::RadioStation>> stations_;
    std::map<std::pair<std::string, std::string>, std::optional<double>> strengths_dbm_;
};

} // namespace usar::server
