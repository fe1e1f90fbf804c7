#include "app/simulator_files.h"

#include "app/locations.h"
#include "core/sim/world_reader.h"

namespace usar::app {

Result<sim::World> loadWorld(const QString& name_or_folder) {
    const Result<QString> folder = findWorld(name_or_folder);
    if (!folder)
        return tl::unexpected(folder.error());
    return sim::readWorld(folder->toStdString());
}

sim::RobotsRead loadRobots() {
    return sim::readRobots(robotsFolder().toStdString());
}

} // namespace usar::app
