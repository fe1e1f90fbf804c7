// Finds behavior plugins, judges them before their code runs, and keeps the refused ones with the reason.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <QJsonObject>
#include <QString>
#include <QStringList>

#include "core/agent/robot_plugin.h"

class QPluginLoader;

namespace usar::agent {

enum class PluginState { Found, Rejected, Loaded };

/// What the host knows of one library file.
struct PluginRecord {
    QString file;
    QJsonObject metadata; ///< the author's own, without Qt's
    PluginState state = PluginState::Found;
    QString reason;                      ///< why it was rejected; empty otherwise
    const RobotPlugin* plugin = nullptr; ///< owned by its library; set when Loaded
};

/// Reads IID and metadata of every library in the folders before opening it; only what passes is loaded. A folder that
/// is missing gives no records; a file that is not named like a library is skipped. Metadata (JSON): name, version,
/// robots (classes on the wire), behaviors (ids, the same as in the description). Files are taken in the order of the
/// folders and of their names; the first to claim a behavior id keeps it. Lives on the GUI thread; loaded plugins are
/// immutable and may be asked for behaviors from any thread; libraries stay open until the program ends.
class PluginLoader {
public:
    PluginLoader();
    ~PluginLoader();

    /// Replaces all records.
    void scan(const QStringList& folders);
    const std::vector<PluginRecord>& records() const { return records_; }

    /// The plugin that has this behavior. The error names the behavior, what is there instead or where nothing was
    /// found, and rejected plugins.
    Result<const RobotPlugin*> pluginFor(const std::string& behavior_id) const;
    /// Its description; nullptr where no loaded plugin has it.
    const BehaviorDescription* behavior(const std::string& behavior_id) const;
    /// The robot that it belongs to; nullptr likewise.
    const RobotDescription* robotOf(const std::string& behavior_id) const;
    /// Descriptions of all loaded plugins.
    const std::vector<RobotDescription>& robots() const { return robots_; }

private:
    /// Why this one cannot be used; empty when it is loaded and its description has joined `robots_`.
    QString judge(PluginRecord& record);
    QString admit(const RobotPlugin& plugin, const QJsonObject& metadata);

    QStringList folders_;
    std::vector<std::unique_ptr<QPluginLoader>> libraries_;
    std::vector<PluginRecord> records_;
    std::vector<RobotDescription> robots_;
    std::vector<const RobotPlugin*> owners_; ///< of `robots_`, index by index
};

} // namespace usar::agent
