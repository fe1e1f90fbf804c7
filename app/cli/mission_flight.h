// The verb of usar-mission that flies a mission.
#pragma once

#include <optional>

#include <QString>
#include <QStringList>

#include "core/agent/plugins/plugin_loader.h"
#include "core/base/result.h"
#include "core/sim/prepared_world.h"

namespace usar::app {

/// Plugins, robots and the world of a flight, which a process that makes a copy of itself for each flight loads before:
/// then no copy has to read their files, nor to make what rays and contacts are searched in.
class Preloaded {
public:
    /// Loads everything for a flight in this world, in place of the world that was loaded before. What cannot be read
    /// is left for the flight to complain about.
    void load(const QString& world);

    /// The program's plugins, and those in these folders.
    const agent::PluginLoader& plugins(const QStringList& more_folders);
    /// The world by its name or folder, as server::loadWorld reads it. It can be taken once; then it is read again.
    Result<sim::PreparedWorld> takeWorld(const QString& name);

private:
    agent::PluginLoader plugins_;
    QString world_name_;
    std::optional<sim::PreparedWorld> world_; ///< absent: taken, or never loaded
};

/// Loads what a flight with these arguments of `run` needs. Nothing is said about arguments that are wrong.
void preloadFor(const QStringList& arguments, Preloaded& loaded);

/// Flies the mission of `run`; `arguments` begin with the verb. Returns the program's exit code, and prints the summary
/// as the last line of standard output.
int flyMission(const QStringList& arguments, Preloaded& loaded);

} // namespace usar::app
