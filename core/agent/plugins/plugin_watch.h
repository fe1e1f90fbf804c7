// Detects that a plugin was rebuilt.
#pragma once

#include <QFileSystemWatcher>
#include <QStringList>
#include <QTimer>

namespace usar::agent {

/// Watches folders and the files in them. A linker writes in many steps, so `changed` is emitted only after nothing has
/// changed for a while. Belongs to the GUI thread.
class PluginWatch : public QObject {
    Q_OBJECT
public:
    PluginWatch();

    /// Adds folders to watch. Call it again after `changed`, because replacing a file ends its watch.
    void watch(const QStringList& folders);

signals:
    void changed();

private:
    QFileSystemWatcher watcher_;
    QTimer calm_; ///< restarted by each change; emits `changed` when it expires
};

} // namespace usar::agent
