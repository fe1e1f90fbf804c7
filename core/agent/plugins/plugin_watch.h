// Sees when a plugin is built anew.
#pragma once

#include <QFileSystemWatcher>
#include <QStringList>
#include <QTimer>

namespace usar::agent {

/// Watches folders and the files in them; a linker writes in many steps, so the word comes once nothing has moved for a
/// while. GUI thread.
class PluginWatch : public QObject {
    Q_OBJECT
public:
    explicit PluginWatch(QObject* parent = nullptr);

    /// Call it again after `changed`: replacing a file ends its watch.
    void watch(const QStringList& folders);

signals:
    void changed();

private:
    QFileSystemWatcher watcher_;
    QTimer calm_;
};

} // namespace usar::agent
