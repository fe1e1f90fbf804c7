// The worlds and robots that come with the program, read for the embedded simulator.
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

namespace usar::server {

/// By name, or from a folder.
Result<sim::World> loadWorld(const QString& name_or_folder);

/// What cannot be read is left out and said.
sim::RobotsRead loadRobots();

/// Goes on from a snapshot's file, in its own world. It takes as long as the run took, divided by some hundred, unless
/// `watch` gives it up.
Result<std::unique_ptr<sim::Simulation>> resumeSimulation(const QString& path,
                                                          std::shared_ptr<const sim::RobotCatalog> robots,
                                                          const sim::Simulation::ResumeWatch& watch = {});
/// A file that is there is replaced only by a whole one.
Result<void> saveSnapshot(const sim::Simulation& simulation, const QString& path);

QStringList textsOf(const std::vector<std::string>& texts);
/// Of texts as people write them; the first that cannot be read is an error with the text and its mend.
Result<std::vector<sim::Fault>> readFaults(const QStringList& texts);

/// What --help says of --fault: every kind with its keys.
QString faultHelp();

} // namespace usar::server
