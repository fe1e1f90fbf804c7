// Reads and writes the files of an embedded simulator: worlds, robots and snapshots; also the texts of faults.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <QString>
#include <QStringList>

#include "core/base/result.h"
#include "core/sim/faults/fault.h"
#include "core/sim/robots/robot_reader.h"
#include "core/sim/simulation.h"
#include "core/sim/world/world.h"
#include "core/usage/program.h"

namespace usar::server {

/// Reads a world that comes with the program, by its name, or the world in a folder; makes one from a name and a seed,
/// such as "town:7".
Result<sim::World> loadWorld(const QString& name_or_folder);

/// Reads the robot files that come with the program. Files that cannot be read are left out and listed with the reason.
/// Any thread may call it. The next call is fast, because what was read is kept (sim::readRobot).
sim::RobotsRead loadRobots();

/// Resumes the simulation of a snapshot file (at most 512 MiB) in the snapshot's own world. The run is simulated again,
/// some hundred times faster than real time, unless `watch` cancels it. Errors name the file.
Result<std::unique_ptr<sim::Simulation>> resumeSimulation(const QString& path,
                                                          std::shared_ptr<const sim::RobotCatalog> robots,
                                                          const sim::Simulation::ResumeWatch& watch = {});
/// Writes a snapshot of the current state. An existing file is replaced only after everything has been written.
Result<void> saveSnapshot(const sim::Simulation& simulation, const QString& path);

QStringList textsOf(const std::vector<std::string>& texts);
/// Reads faults from texts in the syntax of --fault. The error names the first text that is not a fault, and the
/// remedy.
Result<std::vector<sim::Fault>> readFaults(const QStringList& texts);

/// The part of --help that explains --fault: every kind of fault with its keys, units and ranges.
usage::Section faultSection();

} // namespace usar::server
