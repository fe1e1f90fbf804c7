// The plugins' part of MainWindow: what was refused, what is built anew while the program runs, and what broke in the
// air.
#include <algorithm>
#include <chrono>
#include <utility>

#include <QFileInfo>

#include "app/main_window.h"

namespace usar::app {

namespace {

QString behaviorsOf(const agent::PluginRecord& record) {
    QStringList ids;
    for (const QVariant& id : record.metadata.toVariantMap().value("behaviors").toList())
        ids << id.toString();
    return ids.join(", ");
}

} // namespace

void MainWindow::registerPluginCommands() {
    commands_.add({"plugins.rescan",
                   tr("Look for new plugins"),
                   tr("Robots"),
                   tr("Loads robot plugins that were built or copied since; running behaviors go on as they are"),
                   "reset",
                   {QKeySequence("Ctrl+F5")}},
                  [this](bool) { rescanPlugins(true); });
}

void MainWindow::wirePlugins() {
    views_.behavior->setRescanAction(commands_.action("plugins.rescan"));
    connect(views_.behavior, &widgets::BehaviorPanel::isolationChosen, this,
            [this](bool isolated) { setIsolated(chosenPlugin(), isolated); });
    connect(&control_, &MissionControl::pluginsChanged, this, &MainWindow::showPlugins);
    preview_due_.setSingleShot(true);
    preview_due_.setInterval(std::chrono::milliseconds(150)); // a quick one does not flicker
    connect(&preview_due_, &QTimer::timeout, this, [this] {
        views_.map->setLanes(std::vector<Vec2>{});
        views_.map->setAreaSummary({});
        views_.behavior->setPlanSummary(tr("Asking the plugin's process what this would come to…"));
    });
    plugin_watch_.watch(control_.plugins().folders());
    connect(&plugin_watch_, &PluginWatch::changed, this, [this] { rescanPlugins(false); });
}

void MainWindow::loadPlugins(const QStringList& folders) {
    isolated_plugins_ = QSettings().value("isolated_plugins").toStringList();
    applyIsolation();
    control_.loadPlugins(folders);
}

/// Marks lie beside the settings.
void MainWindow::applyIsolation() {
    control_.isolatePlugins(isolated_plugins_, QFileInfo(QSettings().fileName()).path() + "/plugins");
}

void MainWindow::tellRefused(const agent::PluginRecord& record) {
    const QString text = tr("Plugin %1 was refused: %2").arg(record.file, record.reason);
    if (record.isolated) {
        const widgets::Offer again{tr("Ask again"), tr("Starts a new process, which loads the plugin as it is now")};
        return offer(Severity::Warning, record.file, text, again, [this, file = record.file] {
            control_.askPluginAgain(file);
            rescanPlugins(false);
        });
    }
    if (!record.dangerous)
        return say(Severity::Warning, record.file, text);
    const QString name = record.metadata.value("name").toString();
    const widgets::Offer isolation{tr("Give %1 its own process").arg(name),
                                   tr("Its code then runs there only, and cannot end this program any more")};
    offer(Severity::Warning, record.file, text, isolation, [this, name] { setIsolated(name, true); });
}

void MainWindow::tellPlugins(const QStringList& folders) {
    for (const agent::PluginRecord& record : control_.plugins().records())
        if (record.state == agent::PluginState::Rejected)
            tellRefused(record);
    if (control_.plugins().kinds().empty())
        say(Severity::Error, "plugins",
            tr("No robot plugin was found in %1, so no robot has a behavior. Build the target usar_plugin_airrobot, "
               "or name another folder with --plugins.")
                .arg(folders.join(", ")));
}

void MainWindow::rescanPlugins(bool asked) {
    const auto changes = control_.rescanPlugins();
    plugin_watch_.watch(control_.plugins().folders());
    if (!changes.empty())
        return showPlugins(changes);
    if (asked)
        views_.notifications->push("plugins-same", Severity::Note, tr("No plugin is new."), true);
}

void MainWindow::showPlugins(const std::vector<agent::PluginChange>& changes) {
    for (const agent::PluginChange& change : changes)
        tellChange(change);
    views_.spawn_card->setRobots(robotsToSpawn(world_picture_.robot_classes));
    selectRobot(selected_);
    showChosenBehavior();
    if (awaiting_plugin_)
        setUp(*std::exchange(awaiting_plugin_, std::nullopt)); // or waits on
}

void MainWindow::tellChange(const agent::PluginChange& change) {
    const agent::PluginRecord& record = change.record;
    const QString name = QFileInfo(record.file).fileName();
    QStringList old_ones;
    for (const Robot* robot : control_.robots())
        if (const auto* of = control_.plugins().recordOf(robot->view().behavior_id);
            robot->running() && of && of->file == record.file)
            old_ones << QString::fromStdString(robot->view().spawn.robot_name);
    switch (change.news) {
    case agent::PluginNews::Refused:
        return tellRefused(record);
    case agent::PluginNews::Asked:
    case agent::PluginNews::Described:
        return control_.cure(record.file); // its row says the rest
    case agent::PluginNews::Moved:
        control_.cure(record.file);
        return views_.notifications->push("plugin/" + record.file, Severity::Note,
                                          record.isolated ? tr("The plugin %1 has a process of its own now.").arg(name)
                                                          : tr("The plugin %1 runs in the program now.").arg(name));
    case agent::PluginNews::Removed:
        return say(Severity::Warning, record.file,
                   tr("The plugin %1 is gone, and its behaviors can no longer be started.").arg(name));
    case agent::PluginNews::Added:
        control_.cure("plugins");
        break;
    case agent::PluginNews::Rebuilt:
        break;
    }
    control_.cure(record.file);
    QString text = change.news == agent::PluginNews::Added
                       ? tr("The plugin %1 was loaded: %2.").arg(name, behaviorsOf(record))
                       : tr("The plugin %1 was built anew, and what is started from now on is the new code.").arg(name);
    if (!old_ones.isEmpty())
        text += ' ' + tr("%1 goes on with the old one until it is started again.").arg(old_ones.join(", "));
    views_.notifications->push("plugin/" + record.file, Severity::Note, text, true);
}

void MainWindow::showChosenBehavior() {
    const std::string id = views_.behavior->behaviorId();
    const auto* behavior = control_.plugins().behavior(id);
    forms_wait_ = control_.plugins().isAsked(id);
    views_.spawn_card->preferBehavior(QString::fromStdString(id));
    views_.parameters->setSpecs(behavior ? behavior->parameters : std::vector<agent::ParameterSpec>());
    if (const TaskDraft& draft = drafts_[selected_]; draft.behavior_id == id) {
        views_.parameters->setValues(draft.values);
        views_.behavior->plan().choose(draft.plan_path);
    }
    views_.behavior->setIsolated(isolated_plugins_.contains(chosenPlugin()));
    workshop_.follow(selected_);
    showPlan();
}

QString MainWindow::chosenPlugin() const {
    const auto* record = control_.plugins().recordOf(views_.behavior->behaviorId());
    return record ? record->metadata.value("name").toString() : QString();
}

void MainWindow::setIsolated(const QString& plugin, bool isolated) {
    isolated_plugins_.removeAll(plugin);
    if (isolated && !plugin.isEmpty())
        isolated_plugins_ << plugin;
    applyIsolation();
    if (std::ranges::any_of(control_.plugins().records(), [&](const agent::PluginRecord& record) {
            return record.metadata.value("name").toString() == plugin &&
                   (isolated ? record.dangerous : record.isolated);
        }))
        rescanPlugins(false);
    views_.behavior->setIsolated(isolated_plugins_.contains(chosenPlugin()));
}

void MainWindow::startAgain(int id) {
    if (const auto started = control_.startAgain(id); !started)
        return complain("start", started.error());
    begun(id);
    presenter_.showRow(id);
    refreshRunState();
    commands_.refresh();
}

int MainWindow::brokenRobot() const {
    const auto broke = [this](int id) {
        const Robot* const robot = control_.robot(id);
        return robot && robot->view().broke && robot->view().figures.spawned;
    };
    if (broke(selected_))
        return selected_;
    for (const Robot* robot : control_.robots())
        if (broke(robot->view().id))
            return robot->view().id;
    return 0;
}

void MainWindow::offerToStartAgain(int id, const QString& key, const QString& text) {
    const QString name = QString::fromStdString(control_.robot(id)->view().spawn.robot_name);
    const bool was_isolated = control_.robot(id)->started()->isolated;
    QString help = was_isolated ? tr("The same behavior with the same parameters")
                                : tr("The same behavior with the same parameters, in a process of its own, where it "
                                     "can disturb nothing else");
    help += " (" + commands_.action("mission.start_again")->shortcut().toString(QKeySequence::NativeText) + ")";
    offer(Severity::Warning, key, text, {tr("Start %1 again").arg(name), help}, [this, id] { startAgain(id); });
    commands_.refresh();
}

} // namespace usar::app
