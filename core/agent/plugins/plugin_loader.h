// Finds behavior plugins, checks them before their code runs, and keeps the rejected ones with the reason.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <QJsonObject>
#include <QObject>
#include <QString>
#include <QStringList>
#include <QTemporaryDir>

#include "core/agent/plugins/isolated_plugin.h"
#include "core/agent/plugins/plugin_marks.h"
#include "core/agent/robot_plugin.h"

namespace usar::agent {

/// The plugins that are not loaded into this program, and the means to survive those that are.
struct PluginPolicy {
    QString host_program;   ///< path of usar-behavior-host; empty: nothing is isolated
    QStringList isolated;   ///< the "name" in the metadata of each isolated plugin
    PluginMarks marks = {}; ///< remembers plugins whose loading ended the program
    Patience patience = {};
};

/// Asked: a process of its own loads the plugin and has not answered yet.
enum class PluginState { Found, Asked, Rejected, Loaded };

/// All that is known about one library file.
struct PluginRecord {
    QString file;
    QJsonObject metadata; ///< the author's metadata, without Qt's
    PluginState state = PluginState::Found;
    QString reason;                      ///< why it was rejected; empty otherwise
    const RobotPlugin* plugin = nullptr; ///< owned by the loader; set if Loaded, else nullptr
    bool isolated = false;               ///< its code runs in a process of its own only
    bool dangerous = false;              ///< rejected because loading it ended the program
};

/// The change of a file since the last scan. Moved: between this program and a process of its own. Asked: the final
/// news follow when the process has answered. Described: a plugin of the first scan has answered.
enum class PluginNews { Added, Rebuilt, Moved, Removed, Refused, Asked, Described };
struct PluginChange {
    PluginNews news = PluginNews::Added;
    PluginRecord record; ///< the current record, or the last one of a removed file
};

/// Reads the IID and metadata of every library in the folders before opening it, and loads only those that pass. A
/// missing folder gives no records; files not named like a library are skipped. Metadata (JSON): name, version, robots
/// (classes on the wire), behaviors (ids, the same as in the description). Files are taken in the order of the folders
/// and of their names; the first plugin to claim a behavior id keeps it.
///
/// A plugin that the policy isolates is never opened here: a process of its own loads it, and until that has answered,
/// only the metadata is known. A plugin whose loading ended the program is rejected until it is rebuilt or isolated.
///
/// A library is loaded from a copy, so that its file can be rewritten at any time and the new code is loaded then. Old
/// code stays in memory until the program ends, so that running behaviors continue with the code they began with.
/// Belongs to the GUI thread, which never waits for a process; loaded plugins are immutable and may create behaviors in
/// any thread.
class PluginLoader {
public:
    using News = std::function<void(const std::vector<PluginChange>&)>;
    using Told = std::function<void(const Result<TaskPreview>&)>;

    /// Call it before a scan. A plugin already loaded into this program is isolated only after a restart.
    void setPolicy(PluginPolicy policy) { policy_ = std::move(policy); }
    /// Scans the folders and replaces all records. An entry may also be a file.
    void scan(const QStringList& folders);
    /// Scans the same folders again. Unchanged files keep their code. Invalidates records and descriptions in any case.
    std::vector<PluginChange> rescan();
    /// Sets the callback that is called from the event loop when isolated plugins have answered.
    void setNews(News news) { news_ = std::move(news); }
    /// Makes the next rescan open the file as if it had never been seen.
    void forget(const QString& file);
    const QStringList& folders() const { return folders_; }
    const std::vector<PluginRecord>& records() const { return records_; }

    /// The plugin that has this behavior. The error names the behavior, the known behaviors or else the folders, and
    /// the rejected plugins.
    Result<const RobotPlugin*> pluginFor(const std::string& behavior_id) const;
    /// The description of a behavior; nullptr if no loaded plugin has it. Valid until the next scan or news.
    const BehaviorDescription* behavior(const std::string& behavior_id) const;
    /// The record of the plugin, loaded or asked, that has the behavior; nullptr if there is none.
    const PluginRecord* recordOf(const std::string& behavior_id) const;
    /// True if only the behavior's id is known so far.
    bool isAsked(const std::string& behavior_id) const;
    /// Computes the preview of a task. `told` is called at once, or, if the plugin is isolated, later from the event
    /// loop, unless another preview is requested or `forgetPreview` is called before.
    void preview(const std::string& behavior_id, const BehaviorContext& context, const Told& told) const;
    void forgetPreview() const;
    /// The robot that the behavior belongs to; nullptr if no loaded plugin has the behavior.
    const RobotDescription* robotOf(const std::string& behavior_id) const;
    /// Descriptions of all loaded plugins.
    const std::vector<RobotDescription>& robots() const { return robots_; }
    /// One description for each robot class, by the first plugin that has it, with the behaviors of all plugins for
    /// this class. Behaviors of plugins that have not answered yet have only their ids.
    std::vector<RobotDescription> kinds() const;

private:
    struct Library;

    void openAll();
    /// The library as opened before if its file is unchanged and it runs where the policy wants it, else opened again.
    std::shared_ptr<Library> libraryOf(const QString& file, const std::vector<std::shared_ptr<Library>>& known);
    void openLibrary(Library& library);
    void isolate(Library& library);
    bool isToBeIsolated(const QJsonObject& metadata) const;

    /// Rebuilds the records and returns the changes.
    std::vector<PluginChange> judge(bool first_time);
    PluginRecord recordFor(const Library& library);
    PluginNews newsOf(const PluginRecord* before, const PluginRecord& now, bool first_time);
    /// Adds the description to `robots_`, or returns the reason why the plugin cannot be used.
    QString admit(const Library& library);

    QStringList folders_;
    PluginPolicy policy_;
    QTemporaryDir copies_;
    int copies_made_ = 0;
    std::vector<std::shared_ptr<Library>> libraries_; ///< one for each of `records_`
    std::vector<PluginRecord> records_;
    std::vector<RobotDescription> robots_;
    std::vector<const RobotPlugin*> owners_;  ///< the plugin of each of `robots_`
    std::map<QString, PluginNews> owed_news_; ///< by file; for when the plugin has answered
    News news_;
    QObject self_; ///< its destruction cancels queued news
};

} // namespace usar::agent
