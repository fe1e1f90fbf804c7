// What the user is told about plugins that were found, rebuilt, moved or removed.
#pragma once

#include <QStringList>

#include "core/agent/plugins/plugin_loader.h"
#include "core/mission/fleet/fleet_questions.h"

namespace usar::mission {

/// The name that the plugin's author gave it.
QString nameOf(const agent::PluginRecord& record);
/// "loaded", "refused"
QString stateText(const agent::PluginRecord& record);
/// Returns what the plugin's metadata list under this key, such as "behaviors" or "robots".
QStringList listedIn(const agent::PluginRecord& record, const QString& key);
/// Types on the wire of the sensors that the plugin's behaviors need, each once; empty for a plugin that is not loaded,
/// or has not answered yet.
QStringList sensorsNeeded(const agent::PluginRecord& record, const agent::PluginLoader& plugins);
/// Names of the robots whose running behavior is of this plugin, and goes on with the code that it began with.
QStringList robotsRunning(const Robots& robots, const agent::PluginLoader& plugins, const agent::PluginRecord& record);
/// A sentence or two about the change; empty if it needs none or, for a refused plugin, needs a button. `running`: see
/// `robotsRunning`.
QString changeText(const agent::PluginChange& change, const QStringList& running);

} // namespace usar::mission
