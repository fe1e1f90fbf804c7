// Robot plugins: which were refused, which are rebuilt while the program runs, and which have their own process.
#pragma once

#include <QObject>
#include <QSettings>
#include <QStringList>

#include "app/desks/desk.h"
#include "core/agent/plugins/plugin_watch.h"

namespace usar::app {

/// Loads plugins when it is made, so that what can be spawned is known from the start. GUI thread.
class PluginDesk : public QObject {
    Q_OBJECT
public:
    PluginDesk(const DeskContext& context, const QStringList& folders);

    void registerCommands();
    /// Once commands are registered.
    void wire();
    void save(QSettings& settings) const;
    /// Says which plugins were refused; once the notifications can be seen.
    void tellRefused();

    /// Name of the plugin that has this behavior; empty if none has.
    QString pluginOf(const std::string& behavior_id) const;
    /// Behaviors of this plugin run in a process of their own.
    bool isolates(const QString& plugin) const { return isolated_.contains(plugin); }
    void setIsolated(const QString& plugin, bool isolated);

signals:
    /// What can be spawned and started is different now.
    void changed();
    void isolationChanged();

private:
    void applyIsolation();
    void tellRefused(const agent::PluginRecord& record);
    /// What was rebuilt decides from the next start on. `asked`: by the user, who is also told if nothing is new.
    void rescan(bool asked);
    void take(const std::vector<agent::PluginChange>& changes);
    void tell(const agent::PluginChange& change);
    void tellLoaded(const agent::PluginChange& change);

    DeskContext desk_;
    agent::PluginWatch watch_;
    QStringList folders_;
    QStringList isolated_; ///< plugins by name
};

} // namespace usar::app
