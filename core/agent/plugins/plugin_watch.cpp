#include "core/agent/plugins/plugin_watch.h"

#include <chrono>

#include <QDir>

namespace usar::agent {

PluginWatch::PluginWatch() {
    calm_.setSingleShot(true);
    calm_.setInterval(std::chrono::milliseconds{700});
    connect(&watcher_, &QFileSystemWatcher::directoryChanged, &calm_, qOverload<>(&QTimer::start));
    connect(&watcher_, &QFileSystemWatcher::fileChanged, &calm_, qOverload<>(&QTimer::start));
    connect(&calm_, &QTimer::timeout, this, &PluginWatch::changed);
}

void PluginWatch::watch(const QStringList& folders) {
    for (const QString& folder : folders) {
        watcher_.addPath(folder);
        for (const QFileInfo& file : QDir(folder).entryInfoList(QDir::Files))
            watcher_.addPath(file.absoluteFilePath());
    }
}

} // namespace usar::agent
