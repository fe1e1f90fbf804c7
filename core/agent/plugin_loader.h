// Finds behavior plugins, judges them before their code runs, and keeps the refused ones with the reason.
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

#include "core/agent/isolated_plugin.h"
#include "core/agent/plugin_marks.h"
#include "core/agent/robot_plugin.h"

namespace usar::agent {

/// Which plugins do not come into this program, and how it survives those that do.
struct PluginPolicy {
    QString host_program;   ///< path of usar-behavior-host; empty: nothing is isolated
    QStringList isolated;   ///< by the "name" of their metadata
    PluginMarks marks = {}; ///< of loading
    IsolationPatience patience = {};
};

/// Asked: by a process of its own, which has not answered yet.
enum class PluginState { Found, Asked, Rejected, Loaded };

/// What the host knows of one library file.
struct PluginRecord {
    QString file;
    QJsonObject metadata; ///< the author's own, without Qt's
    PluginState state = PluginState::Found;
    QString reason;                      ///< why it was rejected; empty otherwise
    const RobotPlugin* plugin = nullptr; ///< owned by its library; set when Loaded
    bool isolated = false;               ///< its code is in a process of its own, and none of it in this program
    bool dangerous = false;              ///< rejected because loading it ended the program
};

/// What a file has become since it was judged before.
/// Moved: between this program and a process of its own. Asked: what it has become is told once it has answered.
/// Described: it was there at the first scan, and has answered.
enum class PluginNews { Added, Rebuilt, Moved, Removed, Refused, Asked, Described };
struct PluginChange {
    PluginNews news = PluginNews::Added;
    PluginRecord record; ///< as it is now; of a removed one, as it was
};

/// Reads IID and metadata of every library in the folders before opening it; only what passes is loaded. A folder that
/// is missing gives no records; a file that is not named like a library is skipped. Metadata (JSON): name, version,
/// robots (classes on the wire), behaviors (ids, the same as in the description). Files are taken in the order of the
/// folders and of their names; the first to claim a behavior id keeps it.
///
/// One that is isolated by the policy is never opened here: a process of its own is asked, and until it has answered
/// the metadata alone say what there is. One whose loading ended the program is rejected, until it is built anew or
/// isolated.
///
/// A library is loaded from a copy of its own, so that its file can be written anew at any time and what is loaded then
/// is the new code. What was loaded stays in memory until the program ends: behaviors that run go on with the code that
/// they began with. Lives on the GUI thread, which never waits for a process; loaded plugins are immutable and may be
/// asked for behaviors from any thread.
class PluginLoader {
public:
    using News = std::function<void(const std::vector<PluginChange>&)>;
    using Told = std::function<void(const Result<TaskPreview>&)>;

    PluginLoader();
    ~PluginLoader();

    /// Before a scan. One that was loaded into this program already is isolated from the next start on only.
    void setPolicy(PluginPolicy policy) { policy_ = std::move(policy); }
    /// Replaces all records. A file stands for itself.
    void scan(const QStringList& folders);
    /// The same folders again. Files that were not written since keep their code; descriptions move all the same.
    std::vector<PluginChange> rescan();
    /// Told from the event loop what has come of those that were asked.
    void setNews(News news) { news_ = std::move(news); }
    /// The next scan opens it, or asks, as if it had never been seen.
    void forget(const QString& file);
    const QStringList& folders() const { return folders_; }
    const std::vector<PluginRecord>& records() const { return records_; }

    /// The plugin that has this behavior. The error names the behavior, what is there instead or where nothing was
    /// found, and rejected plugins.
    Result<const RobotPlugin*> pluginFor(const std::string& behavior_id) const;
    /// Its description; nullptr where no loaded plugin has it.
    const BehaviorDescription* behavior(const std::string& behavior_id) const;
    /// The file that it comes from, loaded or asked; nullptr likewise.
    const PluginRecord* recordOf(const std::string& behavior_id) const;
    /// It is known by its name alone yet.
    bool isAsked(const std::string& behavior_id) const;
    /// What a task would come to. Told at once; where the plugin has a process of its own later, and then only if no
    /// other preview was wanted since, nor this one forgotten.
    void preview(const std::string& behavior_id, const BehaviorContext& context, const Told& told) const;
    void forgetPreview() const;
    /// The robot that it belongs to; nullptr likewise.
    const RobotDescription* robotOf(const std::string& behavior_id) const;
    /// Descriptions of all loaded plugins.
    const std::vector<RobotDescription>& robots() const { return robots_; }
    /// One for each class on the wire, as the first plugin describes it, with the behaviors that all plugins have for
    /// it; those of a plugin that is asked with nothing but their ids.
    std::vector<RobotDescription> kinds() const;

private:
    struct Library;

    void openAll();
    /// As it was opened before, if its file is the same still and it lives where the policy wants it.
    std::shared_ptr<Library> libraryOf(const QString& file, const std::vector<std::shared_ptr<Library>>& known);
    void openLibrary(Library& library);
    void isolate(Library& library);
    bool isToBeIsolated(const QString& name) const;

    /// Makes the records anew.
    std::vector<PluginChange> judge(bool first_time);
    PluginRecord recordFor(const Library& library);
    PluginNews newsOf(const PluginRecord* before, const PluginRecord& now, bool first_time);
    /// Why this one cannot be used; empty when its description has joined `robots_`.
    QString admit(const Library& library);

    QStringList folders_;
    PluginPolicy policy_;
    QTemporaryDir copies_;
    int copies_made_ = 0;
    std::vector<std::shared_ptr<Library>> libraries_; ///< of `records_`, index by index
    std::vector<PluginRecord> records_;
    std::vector<RobotDescription> robots_;
    std::vector<const RobotPlugin*> owners_;  ///< of `robots_`, index by index
    std::map<QString, PluginNews> owed_news_; ///< by file: once it has answered
    News news_;
    QObject self_; ///< no news after the end
};

} // namespace usar::agent
