// The simulator alone, for any USARSim client: what usar-sim runs once its command line is read.
#pragma once

#include <functional>

#include "core/server/embedded/simulator_settings.h"

namespace usar::server {

/// Opens the server and its channels, and runs an event loop until Ctrl+C or a stop signal. `say` gets a sentence for
/// everything that is worth knowing, in any moment; where clients find the simulator is printed to standard output.
/// Returns the exit code; an error names the port or the snapshot that could not be used.
Result<int> runSimulator(const SimulatorSettings& settings, std::unique_ptr<sim::Simulation> simulation,
                         const std::function<void(const QString& sentence)>& say);

} // namespace usar::server
