#include "app/desks/plugin_desk.h"

#include <algorithm>

#include <QFileInfo>

namespace usar::app {

namespace {

QString nameIn(const agent::PluginRecord& record) {
    return record.metadata.value("name").toString();
}

QString behaviorsOf(const agent::PluginRecord& record) {
    QStringList ids;
    for (const QVariant& id : record.metadata.toVariantMap().value("behaviors").toList())
        ids << id.toString();
    return ids.join(", ");
}

} // namespace

PluginDesk::PluginDesk(const DeskContext& context, const QStringList& folders)
    : Desk(context)
    , folders_(folders)
    , isolated_(QSettings().value("isolated_plugins").toStringList()) {
    applyIsolation();
    control_.plugins().scan(folders);
}

void PluginDesk::wire() {
    views_.behavior->setRescanAction(action("plugins.rescan"));
    connect(&control_, &MissionControl::pluginsChanged, this, &PluginDesk::take);
    watch_.watch(control_.plugins().folders());
    connect(&watch_, &agent::PluginWatch::changed, this, [this] { rescan(false); });
}

/// Also sets the folder for marks of plugins that have ended the program; it is beside the settings file.
void PluginDesk::applyIsolation() {
    control_.isolatePlugins(isolated_, QFileInfo(QSettings().fileName()).path() + "/plugins");
}

void PluginDesk::tellRefused(const agent::PluginRecord& record) {
    const QString text = tr("Plugin %1 was refused: %2").arg(record.file, record.reason);
    if (record.isolated) {
        const widgets::Offer again{tr("Ask again"), tr("Starts a new process, which loads the plugin as it is now")};
        return notices_.offer(Severity::Warning, record.file, text, again, [this, file = record.file] {
            control_.plugins().forget(file);
            rescan(false);
        });
    }
    if (!record.dangerous)
        return notices_.say(Severity::Warning, record.file, text);
    const QString name = nameIn(record);
    const widgets::Offer isolation{tr("Give %1 its own process").arg(name),
                                   tr("Its code then runs there only, and cannot end this program any more")};
    notices_.offer(Severity::Warning, record.file, text, isolation, [this, name] { setIsolated(name, true); });
}

void PluginDesk::tellRefused() {
    for (const agent::PluginRecord& record : control_.plugins().records())
        if (record.state == agent::PluginState::Rejected)
            tellRefused(record);
    if (control_.plugins().kinds().empty())
        notices_.say(
            Severity::Error, "plugins",
            tr("No robot plugin was found in %1, so no robot has a behavior. Build the target usar_plugin_airrobot, "
               "or name another folder with --plugins.")
                .arg(folders_.join(", ")));
}

void PluginDesk::rescan(bool asked) {
    const auto changes = control_.plugins().rescan();
    watch_.watch(control_.plugins().folders());
    if (!changes.empty())
        return take(changes);
    if (asked)
        notices_.note("plugins-same", tr("No plugin is new."));
}

void PluginDesk::take(const std::vector<agent::PluginChange>& changes) {
    for (const agent::PluginChange& change : changes)
        tell(change);
    emit changed();
}

void PluginDesk::tell(const agent::PluginChange& change) {
    const agent::PluginRecord& record = change.record;
    const QString name = QFileInfo(record.file).fileName();
    switch (change.news) {
    case agent::PluginNews::Refused:
        return tellRefused(record);
    case agent::PluginNews::Asked:
    case agent::PluginNews::Described:
        return notices_.cure(record.file); // The behavior panel shows the rest.
    case agent::PluginNews::Moved:
        notices_.cure(record.file);
        return notices_.say(Severity::Note, "plugin/" + record.file,
                            record.isolated ? tr("The plugin %1 runs in a separate process now.").arg(name)
                                            : tr("The plugin %1 runs in the program now.").arg(name));
    case agent::PluginNews::Removed:
        return notices_.say(Severity::Warning, record.file,
                            tr("The plugin %1 is gone, and its behaviors can no longer be started.").arg(name));
    case agent::PluginNews::Added:
        notices_.cure("plugins");
        return tellLoaded(change);
    case agent::PluginNews::Rebuilt:
        return tellLoaded(change);
    }
}

void PluginDesk::tellLoaded(const agent::PluginChange& change) {
    const agent::PluginRecord& record = change.record;
    const QString name = QFileInfo(record.file).fileName();
    QStringList old_ones;
    for (const Robot* robot : control_.robots())
        if (const auto* of = control_.plugins().recordOf(robot->view().behavior_id);
            robot->running() && of && of->file == record.file)
            old_ones << nameOf(*robot);
    notices_.cure(record.file);
    QString text = change.news == agent::PluginNews::Added
                       ? tr("The plugin %1 was loaded: %2.").arg(name, behaviorsOf(record))
                       : tr("The plugin %1 was built anew, and what is started from now on is the new code.").arg(name);
    if (!old_ones.isEmpty())
        text += ' ' + tr("%1 goes on with the old one until it is started again.").arg(old_ones.join(", "));
    notices_.note("plugin/" + record.file, text);
}

QString PluginDesk::pluginOf(const std::string& behavior_id) const {
    const auto* record = control_.plugins().recordOf(behavior_id);
    return record ? nameIn(*record) : QString();
}

void PluginDesk::setIsolated(const QString& plugin, bool isolated) {
    isolated_.removeAll(plugin);
    if (isolated && !plugin.isEmpty())
        isolated_ << plugin;
    applyIsolation();
    if (std::ranges::any_of(control_.plugins().records(), [&](const agent::PluginRecord& record) {
            return nameIn(record) == plugin && (isolated ? record.dangerous : record.isolated);
        }))
        rescan(false);
    emit isolationChanged();
}

} // namespace usar::app
