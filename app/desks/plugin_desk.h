// Desk for robot plugins: loads them, reports refused and rebuilt ones, and gives plugins a process of their own.
#pragma once

#include <QPointer>
#include <QStringList>

#include "app/desks/desk.h"
#include "core/agent/plugins/plugin_watch.h"
#include "widgets/panels/plugin_dialog.h"

namespace usar::app {

/// Loads the plugins in its constructor, so that the robots that can be spawned are known from the start, and watches
/// their files. GUI thread.
class PluginDesk : public Desk {
    Q_OBJECT
public:
    PluginDesk(const DeskContext& context, const QStringList& folders);

    void registerCommands() override;
    void wire() override;
    void save(SettingsSheet& settings) const override { settings.setValue("isolated_plugins", isolated_); }
    /// Reports the refused plugins; to be called once notifications can be seen.
    void tellRefused();

    /// Name of the plugin that has this behavior; empty if none has it.
    QString pluginOf(const std::string& behavior_id) const;
    /// True if behaviors of this plugin are to run in a process of their own.
    bool isolates(const QString& plugin) const { return isolated_.contains(plugin); }
    /// Takes effect for behaviors that are started from now on; kept in the settings.
    void setIsolated(const QString& plugin, bool isolated);

signals:
    /// The robots that can be spawned or the behaviors that can be started have changed.
    void changed();
    void isolationChanged();

private:
    /// Passes the list of isolated plugins to MissionControl.
    void applyIsolation();
    void tellRefused(const agent::PluginRecord& record);
    /// Loads new and rebuilt plugins, which are used from the next start on. `asked`: by the user, who is told even if
    /// nothing has changed.
    void rescan(bool asked);
    void take(const std::vector<agent::PluginChange>& changes);
    /// Opens the list of all plugins, or raises the open one.
    void showList();
    /// Brings the open list up to date.
    void fillList();
    /// Reports a change.
    void tell(const agent::PluginChange& change);

    agent::PluginWatch watch_;
    QPointer<widgets::PluginDialog> list_;
    QStringList folders_;
    QStringList isolated_; ///< names of the plugins
};

} // namespace usar::app
