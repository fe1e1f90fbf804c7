#include "app/desks/plugin_desk.h"

#include <algorithm>

#include <QFileInfo>

#include "core/mission/fleet/plugin_words.h"
#include "widgets/panels/dialogs.h"

namespace usar::app {

PluginDesk::PluginDesk(const DeskContext& context, const QStringList& folders)
    : Desk(context)
    , folders_(folders)
    , isolated_(QSettings().value("isolated_plugins").toStringList()) {
    applyIsolation();
    control_.plugins().scan(folders);
}

void PluginDesk::registerCommands() {
    add("plugins.rescan", [this] { rescan(true); });
    add("plugins.show", [this] { showList(); });
}

void PluginDesk::wire() {
    views_.behavior->setRescanAction(action("plugins.rescan"));
    connect(&control_, &MissionControl::pluginsChanged, this, &PluginDesk::take);
    watch_.watch(control_.plugins().folders());
    connect(&watch_, &agent::PluginWatch::changed, this, [this] { rescan(false); });
    connect(this, &PluginDesk::changed, this, &PluginDesk::fillList);
    connect(this, &PluginDesk::isolationChanged, this, &PluginDesk::fillList);
}

void PluginDesk::showList() {
    if (!list_) {
        list_ = new widgets::PluginDialog(control_.plugins().folders(), window_);
        list_->setAttribute(Qt::WA_DeleteOnClose);
        connect(list_, &widgets::PluginDialog::rescanRequested, this, [this] { rescan(true); });
        // The call is queued, because the list rebuilds its rows in answer.
        connect(list_, &widgets::PluginDialog::isolationRequested, this, &PluginDesk::setIsolated,
                Qt::QueuedConnection);
        fillList();
    }
    widgets::showInFront(list_);
}

void PluginDesk::fillList() {
    if (!list_)
        return;
    std::vector<widgets::PluginRow> rows;
    for (const agent::PluginRecord& record : control_.plugins().records()) {
        const QString name = mission::nameOf(record);
        rows.push_back({name.isEmpty() ? QFileInfo(record.file).fileName() : name,
                        record.metadata.value("version").toString(), mission::stateText(record), record.reason,
                        mission::listedIn(record, "behaviors"), mission::listedIn(record, "robots"),
                        mission::sensorsNeeded(record, control_.plugins()), record.file,
                        name.isEmpty() ? std::nullopt : std::optional(isolates(name))});
    }
    list_->setPlugins(rows);
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
    const QString name = mission::nameOf(record);
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
    using enum agent::PluginNews;
    if (change.news == Refused)
        return tellRefused(record);
    if (change.news != Removed)
        notices_.cure(record.file);
    if (change.news == Added)
        notices_.cure("plugins");
    const QString text =
        mission::changeText(change, mission::robotsRunning(control_.robots(), control_.plugins(), record));
    if (change.news == Removed)
        notices_.say(Severity::Warning, record.file, text);
    else if (!text.isEmpty())
        notices_.say(Severity::Note, "plugin/" + record.file, text, change.news != Moved);
}

QString PluginDesk::pluginOf(const std::string& behavior_id) const {
    const auto* record = control_.plugins().recordOf(behavior_id);
    return record ? mission::nameOf(*record) : QString();
}

void PluginDesk::setIsolated(const QString& plugin, bool isolated) {
    isolated_.removeAll(plugin);
    if (isolated && !plugin.isEmpty())
        isolated_ << plugin;
    applyIsolation();
    if (std::ranges::any_of(control_.plugins().records(), [&](const agent::PluginRecord& record) {
            return mission::nameOf(record) == plugin && (isolated ? record.dangerous : record.isolated);
        }))
        rescan(false);
    emit isolationChanged();
}

} // namespace usar::app
