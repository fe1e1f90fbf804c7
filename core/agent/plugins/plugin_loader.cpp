#include "core/agent/plugins/plugin_loader.h"

#include <algorithm>
#include <exception>
#include <optional>
#include <set>
#include <utility>

#include <QDir>
#include <QFileInfo>
#include <QJsonArray>
#include <QLibrary>
#include <QPluginLoader>

#include "core/agent/behavior_start.h"

namespace usar::agent {

namespace {

QString complaintAboutIid(const QString& iid) {
    const QString ours = USAR_ROBOT_PLUGIN_IID;
    if (iid == ours)
        return {};
    if (iid.section('/', 0, 0) == ours.section('/', 0, 0))
        return QString("It was built for version %1 of the plugin interface; this program has version %2. Rebuild it.")
            .arg(iid.section('/', 1), ours.section('/', 1));
    return QString("It is a Qt plugin, but not a robot plugin (its interface is %1). Remove it from the folder.")
        .arg(iid);
}

bool isTextList(const QJsonValue& value) {
    const QJsonArray list = value.toArray();
    return !list.isEmpty() && std::ranges::all_of(list, [](const QJsonValue& item) { return item.isString(); });
}

QString complaintAboutMetadata(const QJsonObject& metadata) {
    for (const char* key : {"name", "version"})
        if (metadata.value(QLatin1String(key)).toString().isEmpty())
            return QString("Its metadata lack \"%1\" (a text). Add it to the plugin's JSON file.").arg(key);
    for (const char* key : {"robots", "behaviors"})
        if (!isTextList(metadata.value(QLatin1String(key))))
            return QString("Its metadata lack \"%1\" (a list of texts). Add it to the plugin's JSON file.").arg(key);
    return {};
}

/// Problems that can be found before any of the library's code runs; empty if there are none.
QString complaintBeforeLoading(const QJsonObject& raw) {
    if (raw.isEmpty())
        return "It is no Qt plugin, or the file is damaged. Remove it from the folder, or build it again.";
    const int version = raw.value("version").toInt(); // Qt stores its own version as 0xMMmmpp.
    const int major = version >> 16 & 0xff;
    const int minor = version >> 8 & 0xff;
    if (major != QT_VERSION_MAJOR || minor > QT_VERSION_MINOR)
        return QString("It was built with Qt %1.%2; this program runs with Qt %3. Rebuild it.")
            .arg(major)
            .arg(minor)
            .arg(QT_VERSION_STR);
    if (const QString complaint = complaintAboutIid(raw.value("IID").toString()); !complaint.isEmpty())
        return complaint;
    return complaintAboutMetadata(raw.value("MetaData").toObject());
}

QString complaintAboutParameters(const BehaviorDescription& behavior) {
    std::map<std::string, ParameterValue> defaults;
    for (const ParameterSpec& spec : behavior.parameters)
        if (!defaults.emplace(spec.id, spec.default_value).second)
            return QString("Its behavior %1 has the parameter %2 twice. Rename one of them.")
                .arg(QString::fromStdString(behavior.id), QString::fromStdString(spec.id));
    const Result<ParameterSet> set = ParameterSet::make(behavior.parameters, defaults);
    if (!set)
        return QString("A default of its behavior %1 is bad: %2")
            .arg(QString::fromStdString(behavior.id), QString::fromStdString(set.error().text()));
    std::set<std::string> presets;
    for (const ParameterPreset& preset : behavior.presets) {
        const Result<ParameterSet> made = ParameterSet::make(behavior.parameters, preset.values);
        if (!made)
            return QString("The preset %1 of its behavior %2 is bad: %3")
                .arg(QString::fromStdString(preset.id), QString::fromStdString(behavior.id),
                     QString::fromStdString(made.error().text()));
        if (!presets.insert(preset.id).second)
            return QString("Its behavior %1 has the preset %2 twice. Rename one of them.")
                .arg(QString::fromStdString(behavior.id), QString::fromStdString(preset.id));
    }
    return {};
}

QString listed(const std::set<QString>& words) {
    return QStringList(words.begin(), words.end()).join(", ");
}

QStringList textsIn(const QJsonObject& metadata, const char* key) {
    return metadata.value(QLatin1String(key)).toVariant().toStringList();
}

/// Descriptions made from the metadata of a plugin that has not answered yet.
std::vector<RobotDescription> robotsPromised(const QJsonObject& metadata) {
    std::vector<RobotDescription> robots;
    for (const QString& class_name : textsIn(metadata, "robots")) {
        RobotDescription& robot = robots.emplace_back();
        robot.class_name = class_name.toStdString();
        robot.name = class_name.section('.', -1).toStdString();
        for (const QString& id : textsIn(metadata, "behaviors"))
            robot.behaviors.push_back({.id = id.toStdString(),
                                       .name = id.toStdString() + " (asking…)",
                                       .help = "The process of its plugin is being asked what this behavior does.",
                                       .needs_area = false,
                                       .parameters = {}});
    }
    return robots;
}

void join(std::vector<RobotDescription>& kinds, const RobotDescription& robot) {
    const auto known = std::ranges::find(kinds, robot.class_name, &RobotDescription::class_name);
    if (known == kinds.end())
        kinds.push_back(robot);
    else
        known->behaviors.insert(known->behaviors.end(), robot.behaviors.begin(), robot.behaviors.end());
}

} // namespace

/// An opened file and its library.
struct PluginLoader::Library {
    /// Loads the copy of the file, or, if that fails, the file itself, and asks the plugin for its description.
    void open(const QString& copy) {
        // If the copy cannot be loaded, try the original: a library that needs others in its own folder finds them only
        // there.
        if (!QFile::copy(record.file, copy) || !load(copy).isEmpty())
            record.reason = load(record.file);
        if (record.reason.isEmpty())
            describe();
    }
    QString load(const QString& path) {
        loader = std::make_unique<QPluginLoader>(path);
        // Without this, a missing symbol would end the program at its first use instead of failing here.
        loader->setLoadHints(QLibrary::ResolveAllSymbolsHint | QLibrary::PreventUnloadHint);
        QObject* instance = nullptr;
        try {
            instance = loader->instance();
        } catch (...) {
            return "It failed while it was being made. Fix the constructor of its plugin class.";
        }
        if (!instance)
            return "It cannot be loaded: " + loader->errorString() + " Build it again with all the libraries it needs.";
        record.plugin = qobject_cast<RobotPlugin*>(instance);
        if (!record.plugin)
            return "It claims the robot plugin interface but does not implement it (Q_INTERFACES is missing). "
                   "Add Q_INTERFACES(usar::agent::RobotPlugin) to its class.";
        return {};
    }
    void describe() {
        try {
            description = record.plugin->description();
        } catch (const std::exception& thrown) {
            record.reason = QString("It failed while describing itself: %1. Fix its description().").arg(thrown.what());
        } catch (...) {
            record.reason = "It failed while describing itself. Fix its description().";
        }
    }

    /// Its reason is that of the rejection so far; its plugin must not be used if there is one. `judge` sets the state.
    PluginRecord record;
    FileStamp stamp;
    std::optional<RobotDescription> description; ///< absent if rejected or not described yet
    std::unique_ptr<QPluginLoader> loader;       ///< its destructor does not unload the library
    std::unique_ptr<IsolatedPlugin> isolated;    ///< set instead of `loader`
};

void PluginLoader::scan(const QStringList& folders) {
    folders_ = folders;
    libraries_.clear();
    records_.clear();
    owed_news_.clear();
    openAll();
    judge(true);
}

std::vector<PluginChange> PluginLoader::rescan() {
    openAll();
    return judge(false);
}

void PluginLoader::forget(const QString& file) {
    for (const auto& library : libraries_)
        if (library->record.file == file)
            library->stamp = {};
}

void PluginLoader::openAll() {
    const std::vector<std::shared_ptr<Library>> known = std::exchange(libraries_, {});
    for (const QString& folder : folders_)
        if (QFileInfo(folder).isFile())
            libraries_.push_back(libraryOf(QFileInfo(folder).absoluteFilePath(), known));
    for (const QString& folder : folders_)
        for (const QFileInfo& file : QDir(folder).entryInfoList(QDir::Files, QDir::Name))
            if (QLibrary::isLibrary(file.fileName()))
                libraries_.push_back(libraryOf(file.absoluteFilePath(), known));
}

std::vector<PluginChange> PluginLoader::judge(bool first_time) {
    const std::vector<PluginRecord> before = std::exchange(records_, {});
    robots_.clear();
    owners_.clear();
    for (const auto& library : libraries_)
        records_.push_back(recordFor(*library));

    std::vector<PluginChange> changes;
    for (const PluginRecord& record : records_) {
        const auto old = std::ranges::find(before, record.file, &PluginRecord::file);
        const bool same = old != before.end() && old->state == record.state && old->plugin == record.plugin &&
                          old->reason == record.reason;
        if (!same)
            changes.push_back({newsOf(old == before.end() ? nullptr : &*old, record, first_time), record});
    }
    for (const PluginRecord& record : before)
        if (std::ranges::find(records_, record.file, &PluginRecord::file) == records_.end())
            changes.push_back({PluginNews::Removed, record});
    return changes;
}

PluginRecord PluginLoader::recordFor(const Library& library) {
    PluginRecord record = library.record;
    if (record.reason.isEmpty() && library.description)
        record.reason = admit(library);
    record.state = library.description ? PluginState::Loaded : PluginState::Asked;
    if (!record.reason.isEmpty()) {
        record.state = PluginState::Rejected;
        record.plugin = nullptr;
    }
    return record;
}

PluginNews PluginLoader::newsOf(const PluginRecord* before, const PluginRecord& now, bool first_time) {
    if (now.state == PluginState::Rejected)
        return PluginNews::Refused;
    const bool was_asked = before && before->state == PluginState::Asked;
    if (was_asked && now.isolated)
        return owed_news_[now.file];
    const bool new_here = !before || (!before->plugin && !was_asked);
    PluginNews news = new_here ? PluginNews::Added : PluginNews::Rebuilt;
    if (!new_here && before->isolated != now.isolated)
        news = PluginNews::Moved;
    if (now.state != PluginState::Asked)
        return news;
    owed_news_[now.file] = first_time ? PluginNews::Described : news;
    return PluginNews::Asked;
}

std::shared_ptr<PluginLoader::Library> PluginLoader::libraryOf(const QString& file,
                                                               const std::vector<std::shared_ptr<Library>>& known) {
    const FileStamp stamp = stampOf(file);
    for (const auto& library : known) {
        const bool to_be_isolated = isToBeIsolated(library->record.metadata);
        const bool wants_to_move = to_be_isolated ? library->record.dangerous : library->record.isolated;
        if (library->record.file == file && library->stamp == stamp && !wants_to_move)
            return library;
    }
    auto library = std::make_shared<Library>();
    library->record.file = file;
    library->stamp = stamp;
    openLibrary(*library);
    return library;
}

bool PluginLoader::isToBeIsolated(const QJsonObject& metadata) const {
    return !policy_.host_program.isEmpty() && policy_.isolated.contains(metadata.value("name").toString());
}

void PluginLoader::openLibrary(Library& library) {
    PluginRecord& record = library.record;
    const QJsonObject raw = QPluginLoader(record.file).metaData();
    record.metadata = raw.value("MetaData").toObject();
    record.reason = complaintBeforeLoading(raw);
    if (!record.reason.isEmpty())
        return;
    if (isToBeIsolated(record.metadata))
        return isolate(library);
    if (policy_.marks.endedTheProgram(record.file, library.stamp)) {
        record.dangerous = true;
        record.reason = "It ended the program when it was loaded the last time. Build it again, or let it run in a "
                        "separate process.";
        return;
    }
    const QString folder = QString::number(++copies_made_); // a path that was loaded once would not be loaded again
    QDir(copies_.path()).mkpath(folder);
    policy_.marks.begin(record.file, library.stamp);
    library.open(copies_.filePath(folder + '/' + QFileInfo(record.file).fileName()));
    policy_.marks.end(record.file); // all code that runs during loading has run
}

void PluginLoader::isolate(Library& library) {
    library.record.isolated = true;
    library.isolated = std::make_unique<IsolatedPlugin>(policy_.host_program, library.record.file, policy_.patience);
    library.isolated->describe([this, &library](const Result<void>& told) {
        if (!told) {
            library.record.reason = QString::fromStdString(told.error().text());
        } else {
            library.record.plugin = library.isolated.get();
            library.description = library.isolated->description();
        }
        const auto tell = [this] {
            if (const auto changes = judge(false); !changes.empty() && news_)
                news_(changes);
        };
        QMetaObject::invokeMethod(&self_, tell, Qt::QueuedConnection);
    });
}

QString PluginLoader::admit(const Library& library) {
    const QStringList ids = textsIn(library.record.metadata, "behaviors");
    const std::set<QString> promised(ids.begin(), ids.end());
    std::set<QString> described;
    for (const BehaviorDescription& described_behavior : library.description->behaviors) {
        const QString id = QString::fromStdString(described_behavior.id);
        if (!described.insert(id).second || recordOf(described_behavior.id))
            return QString("The behavior %1 is there already. Give it another id.").arg(id);
        if (const QString complaint = complaintAboutParameters(described_behavior); !complaint.isEmpty())
            return complaint;
    }
    if (promised != described)
        return QString("Its metadata promise the behaviors %1, but it describes %2. Make both the same.")
            .arg(listed(promised), described.empty() ? QString("none") : listed(described));
    robots_.push_back(*library.description);
    owners_.push_back(library.record.plugin);
    return {};
}

Result<const RobotPlugin*> PluginLoader::pluginFor(const std::string& behavior_id) const {
    if (const PluginRecord* const record = recordOf(behavior_id); record && record->plugin)
        return record->plugin;
    if (isAsked(behavior_id))
        return failure("its plugin is still being asked what it does", "behavior " + behavior_id,
                       "Wait until its process has answered");
    std::string known;
    for (const RobotDescription& robot : robots_)
        for (const BehaviorDescription& behavior : robot.behaviors)
            known += (known.empty() ? "" : ", ") + behavior.id;
    std::string mend = "There are: " + known;
    if (known.empty())
        mend = "No robot plugin could be loaded from " + folders_.join(" or ").toStdString() +
               "; build or install the program again";
    for (const PluginRecord& record : records_)
        if (record.state == PluginState::Rejected)
            mend +=
                "; " + QFileInfo(record.file).fileName().toStdString() + " was refused: " + record.reason.toStdString();
    return failure("no loaded plugin has this behavior", "behavior " + behavior_id, mend);
}

const RobotDescription* PluginLoader::robotOf(const std::string& behavior_id) const {
    const auto robot = std::ranges::find_if(robots_, [&](const RobotDescription& one) {
        return std::ranges::find(one.behaviors, behavior_id, &BehaviorDescription::id) != one.behaviors.end();
    });
    return robot == robots_.end() ? nullptr : &*robot;
}

const PluginRecord* PluginLoader::recordOf(const std::string& behavior_id) const {
    const RobotDescription* const robot = robotOf(behavior_id);
    const auto found = std::ranges::find_if(records_, [&](const PluginRecord& record) {
        return robot ? record.plugin == owners_[static_cast<std::size_t>(robot - robots_.data())]
                     : record.state == PluginState::Asked &&
                           textsIn(record.metadata, "behaviors").contains(QString::fromStdString(behavior_id));
    });
    return found == records_.end() ? nullptr : &*found;
}

bool PluginLoader::isAsked(const std::string& behavior_id) const {
    const PluginRecord* const record = recordOf(behavior_id);
    return record && record->state == PluginState::Asked;
}

std::vector<RobotDescription> PluginLoader::kinds() const {
    std::vector<RobotDescription> kinds;
    auto described = robots_.begin();
    for (const PluginRecord& record : records_) {
        if (record.state == PluginState::Loaded)
            join(kinds, *described++);
        else if (record.state == PluginState::Asked)
            for (const RobotDescription& robot : robotsPromised(record.metadata))
                join(kinds, robot);
    }
    return kinds;
}

void PluginLoader::preview(const std::string& behavior_id, const BehaviorContext& context, const Told& told) const {
    forgetPreview();
    const auto plugin = pluginFor(behavior_id);
    if (!plugin)
        return told(tl::unexpected(plugin.error()));
    for (const auto& library : libraries_)
        if (library->isolated && library->record.plugin == *plugin)
            return library->isolated->foretell({behavior_id, context.task, context.parameters.values(), context.plan},
                                               told);
    told(previewTask(**plugin, behavior_id, context));
}

void PluginLoader::forgetPreview() const {
    for (const auto& library : libraries_)
        if (library->isolated)
            library->isolated->forgetPreview();
}

const BehaviorDescription* PluginLoader::behavior(const std::string& behavior_id) const {
    const RobotDescription* const robot = robotOf(behavior_id);
    return robot ? &*std::ranges::find(robot->behaviors, behavior_id, &BehaviorDescription::id) : nullptr;
}

} // namespace usar::agent
