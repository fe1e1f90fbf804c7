#include "core/mission/fleet/plugin_words.h"

#include <QFileInfo>
#include <QVariant>

namespace usar::mission {

QStringList listedIn(const agent::PluginRecord& record, const QString& key) {
    return record.metadata.toVariantMap().value(key).toStringList();
}

QString stateText(const agent::PluginRecord& record) {
    const auto tr = [](const char* text) { return QObject::tr(text); };
    using enum agent::PluginState;
    switch (record.state) {
    case Loaded:
        return record.isolated ? tr("in a separate process") : tr("loaded");
    case Asked:
        return tr("being asked");
    case Rejected:
        return tr("refused");
    case Found:
        return tr("found");
    }
    return {};
}

QString nameOf(const agent::PluginRecord& record) {
    return record.metadata.value("name").toString();
}

QStringList sensorsNeeded(const agent::PluginRecord& record, const agent::PluginLoader& plugins) {
    if (!record.plugin)
        return {}; // Another plugin may have the behaviors that its file names.
    QStringList sensors;
    for (const QString& behavior : listedIn(record, "behaviors"))
        if (const auto* const robot = plugins.robotOf(behavior.toStdString()))
            for (const std::string& sensor : robot->sensors_needed)
                sensors << QString::fromStdString(sensor);
    sensors.removeDuplicates();
    return sensors;
}

QStringList robotsRunning(const Robots& robots, const agent::PluginLoader& plugins, const agent::PluginRecord& record) {
    QStringList names;
    for (const Robot* const robot : robots)
        if (const auto* of = plugins.recordOf(robot->view().behavior_id);
            robot->running() && of && of->file == record.file)
            names << nameOf(*robot);
    return names;
}

QString changeText(const agent::PluginChange& change, const QStringList& running) {
    const auto tr = [](const char* text) { return QObject::tr(text); };
    using enum agent::PluginNews;
    const QString name = QFileInfo(change.record.file).fileName();
    if (change.news == Moved)
        return (change.record.isolated ? tr("The plugin %1 runs in a separate process now.")
                                       : tr("The plugin %1 runs in the program now."))
            .arg(name);
    if (change.news == Removed)
        return tr("The plugin %1 is gone, and its behaviors can no longer be started.").arg(name);
    if (change.news != Added && change.news != Rebuilt)
        return {};
    const QString text =
        change.news == Added
            ? tr("The plugin %1 was loaded: %2.").arg(name, listedIn(change.record, "behaviors").join(", "))
            : tr("The plugin %1 was built anew, and what is started from now on is the new code.").arg(name);
    return running.isEmpty()
               ? text
               : text + ' ' + tr("%1 goes on with the old one until it is started again.").arg(running.join(", "));
}

} // namespace usar::mission
