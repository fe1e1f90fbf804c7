#include "core/agent/plugin_loader.h"

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

#include "core/agent/isolated_plugin.h"

namespace usar::agent {

namespace {

/// Qt stores its own version in the metadata as 0xMMmmpp.
bool builtForOurQt(int version) {
    const int major = (version >> 16) & 0xff;
    const int minor = (version >> 8) & 0xff;
    return major == QT_VERSION_MAJOR && minor <= QT_VERSION_MINOR;
}

QString complaintAboutIid(const QString& iid) {
    const QString ours = USAR_ROBOT_PLUGIN_IID;
    const QString family = ours.section('/', 0, 0);
    if (iid == ours)
        return {};
    if (iid.section('/', 0, 0) == family)
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

/// What can be said before any of the library's code runs.
QString complaintBeforeLoading(const QJsonObject& raw) {
    if (raw.isEmpty())
        return "It is no Qt plugin, or the file is damaged. Remove it from the folder, or build it again.";
    if (const int version = raw.value("version").toInt(); !builtForOurQt(version))
        return QString("It was built with Qt %1.%2; this program runs with Qt %3. Rebuild it.")
            .arg(version >> 16 & 0xff)
            .arg(version >> 8 & 0xff)
            .arg(QT_VERSION_STR);
    if (const QString complaint = complaintAboutIid(raw.value("IID").toString()); !complaint.isEmpty())
        return complaint;
    return complaintAboutMetadata(raw.value("MetaData").toObject());
}

std::optional<QString> complaintAboutParameters(const BehaviorDescription& behavior) {
    std::map<std::string, ParameterValue> defaults;
    for (const ParameterSpec& spec : behavior.parameters)
        if (!defaults.emplace(spec.id, spec.default_value).second)
            return QString("Its behavior %1 has the parameter %2 twice. Rename one of them.")
                .arg(QString::fromStdString(behavior.id), QString::fromStdString(spec.id));
    const Result<ParameterSet> set = ParameterSet::make(behavior.parameters, defaults);
    if (!set)
        return QString("A default of its behavior %1 is bad: %2")
            .arg(QString::fromStdString(behavior.id), QString::fromStdString(set.error().text()));
    return std::nullopt;
}

QString listed(const std::set<QString>& words) {
    return QStringList(words.begin(), words.end()).join(", ");
}

} // namespace

/// A file as it was opened: its library, or what was wrong with it.
struct PluginLoader::Library {
    /// What can be known without its code.
    void look();
    void open(const QString& copy);
    void isolate(const QString& host_program);
    QString load(const QString& path);

    QString file;
    FileStamp stamp;
    QJsonObject metadata;
    QString complaint; ///< empty where `plugin` is there
    const RobotPlugin* plugin = nullptr;
    std::unique_ptr<QPluginLoader> loader;    ///< does not unload when it dies
    std::unique_ptr<IsolatedPlugin> isolated; ///< in place of `loader`
    bool apart = false;                       ///< it is isolated, or was to be
    bool dangerous = false;
};

void PluginLoader::Library::look() {
    const QJsonObject raw = QPluginLoader(file).metaData();
    metadata = raw.value("MetaData").toObject();
    complaint = complaintBeforeLoading(raw);
}

void PluginLoader::Library::isolate(const QString& host_program) {
    apart = true;
    auto made = IsolatedPlugin::load(host_program, file);
    if (made) {
        isolated = *std::move(made);
        plugin = isolated.get();
    } else {
        complaint = QString::fromStdString(made.error().text());
    }
}

void PluginLoader::Library::open(const QString& copy) {
    // A library that looks for others beside itself finds them only where it lies.
    if (!QFile::copy(file, copy) || !load(copy).isEmpty())
        complaint = load(file);
}

QString PluginLoader::Library::load(const QString& path) {
    loader = std::make_unique<QPluginLoader>(path);
    // Otherwise a missing symbol would end the program at its first use instead of failing here.
    loader->setLoadHints(QLibrary::ResolveAllSymbolsHint | QLibrary::PreventUnloadHint);
    QObject* instance = nullptr;
    try {
        instance = loader->instance();
    } catch (...) {
        return "It failed while it was being made. Mend the constructor of its plugin class.";
    }
    if (!instance)
        return "It cannot be loaded: " + loader->errorString() + " Build it again with all the libraries it needs.";
    plugin = qobject_cast<RobotPlugin*>(instance);
    if (!plugin)
        return "It claims the robot plugin interface but does not implement it (Q_INTERFACES is missing). "
               "Add Q_INTERFACES(usar::agent::RobotPlugin) to its class.";
    return {};
}

namespace {

PluginNews newsOf(const PluginRecord* before, const PluginRecord& now) {
    if (!before || !before->plugin)
        return PluginNews::Added;
    return before->isolated != now.isolated ? PluginNews::Moved : PluginNews::Rebuilt;
}

} // namespace

PluginLoader::PluginLoader() = default;
PluginLoader::~PluginLoader() = default;

void PluginLoader::scan(const QStringList& folders) {
    folders_ = folders;
    libraries_.clear();
    records_.clear();
    rescan();
}

std::vector<PluginChange> PluginLoader::rescan() {
    const std::vector<std::shared_ptr<Library>> known = std::exchange(libraries_, {});
    const std::vector<PluginRecord> before = std::exchange(records_, {});
    robots_.clear();
    owners_.clear();
    for (const QString& folder : folders_)
        if (QFileInfo(folder).isFile())
            takeFile(QFileInfo(folder).absoluteFilePath(), known);
    for (const QString& folder : folders_)
        for (const QFileInfo& file : QDir(folder).entryInfoList(QDir::Files, QDir::Name))
            if (QLibrary::isLibrary(file.fileName()))
                takeFile(file.absoluteFilePath(), known);

    std::vector<PluginChange> changes;
    for (const PluginRecord& record : records_) {
        const auto old = std::ranges::find(before, record.file, &PluginRecord::file);
        const bool same = old != before.end() && old->plugin == record.plugin && old->reason == record.reason;
        if (record.state == PluginState::Rejected && !same)
            changes.push_back({PluginNews::Refused, record});
        else if (!same)
            changes.push_back({newsOf(old == before.end() ? nullptr : &*old, record), record});
    }
    for (const PluginRecord& record : before)
        if (std::ranges::find(records_, record.file, &PluginRecord::file) == records_.end())
            changes.push_back({PluginNews::Removed, record});
    return changes;
}

void PluginLoader::takeFile(const QString& file, const std::vector<std::shared_ptr<Library>>& known) {
    const auto library = libraryOf(file, known);
    PluginRecord& record = records_.emplace_back();
    record.file = file;
    record.metadata = library->metadata;
    record.reason = library->complaint;
    if (record.reason.isEmpty())
        record.reason = admit(*library->plugin, library->metadata);
    if (library->loader)
        policy_.marks.end(file); // all its code that runs by itself has run
    record.state = record.reason.isEmpty() ? PluginState::Loaded : PluginState::Rejected;
    record.plugin = record.reason.isEmpty() ? library->plugin : nullptr;
    record.isolated = library->apart;
    record.dangerous = library->dangerous;
    libraries_.push_back(library);
}

std::shared_ptr<PluginLoader::Library> PluginLoader::libraryOf(const QString& file,
                                                               const std::vector<std::shared_ptr<Library>>& known) {
    const FileStamp stamp = stampOf(file);
    for (const auto& library : known) {
        const bool to_be_isolated = isToBeIsolated(library->metadata.value("name").toString());
        const bool wants_to_move = to_be_isolated ? library->dangerous : library->apart;
        if (library->file == file && library->stamp == stamp && !wants_to_move)
            return library;
    }
    auto library = std::make_shared<Library>();
    library->file = file;
    library->stamp = stamp;
    openLibrary(*library);
    return library;
}

bool PluginLoader::isToBeIsolated(const QString& name) const {
    return !policy_.host_program.isEmpty() && policy_.isolated.contains(name);
}

void PluginLoader::openLibrary(Library& library) {
    library.look();
    if (!library.complaint.isEmpty())
        return;
    if (isToBeIsolated(library.metadata.value("name").toString()))
        return library.isolate(policy_.host_program);
    if (policy_.marks.endedTheProgram(library.file, library.stamp)) {
        library.dangerous = true;
        library.complaint = "It ended the program when it was loaded the last time. Build it again, or let it run in a "
                            "process of its own.";
        return;
    }
    const QString folder = QString::number(++copies_made_); // a path that was loaded once is never loaded again
    QDir(copies_.path()).mkpath(folder);
    policy_.marks.begin(library.file, library.stamp);
    library.open(copies_.filePath(folder + '/' + QFileInfo(library.file).fileName()));
}

QString PluginLoader::admit(const RobotPlugin& plugin, const QJsonObject& metadata) {
    RobotDescription description;
    try {
        description = plugin.description();
    } catch (const std::exception& thrown) {
        return QString("It failed while describing itself: %1. Mend its description().").arg(thrown.what());
    } catch (...) {
        return "It failed while describing itself. Mend its description().";
    }
    std::set<QString> promised;
    for (const QJsonValue& id : metadata.value("behaviors").toArray())
        promised.insert(id.toString());
    std::set<QString> described;
    for (const BehaviorDescription& described_behavior : description.behaviors) {
        const QString id = QString::fromStdString(described_behavior.id);
        if (!described.insert(id).second || behavior(described_behavior.id))
            return QString("The behavior %1 is there already. Give it another id.").arg(id);
        if (const auto complaint = complaintAboutParameters(described_behavior))
            return *complaint;
    }
    if (promised != described)
        return QString("Its metadata promise the behaviors %1, but it describes %2. Make both the same.")
            .arg(listed(promised), described.empty() ? QString("none") : listed(described));
    robots_.push_back(std::move(description));
    owners_.push_back(&plugin);
    return {};
}

Result<const RobotPlugin*> PluginLoader::pluginFor(const std::string& behavior_id) const {
    std::string known;
    for (std::size_t i = 0; i < robots_.size(); ++i) {
        for (const BehaviorDescription& behavior : robots_[i].behaviors) {
            if (behavior.id == behavior_id)
                return owners_[i];
            known += (known.empty() ? "" : ", ") + behavior.id;
        }
    }
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
    for (const RobotDescription& robot : robots_)
        if (std::ranges::find(robot.behaviors, behavior_id, &BehaviorDescription::id) != robot.behaviors.end())
            return &robot;
    return nullptr;
}

const PluginRecord* PluginLoader::recordOf(const std::string& behavior_id) const {
    for (std::size_t i = 0; i < robots_.size(); ++i)
        if (std::ranges::find(robots_[i].behaviors, behavior_id, &BehaviorDescription::id) !=
            robots_[i].behaviors.end())
            return &*std::ranges::find(records_, owners_[i], &PluginRecord::plugin);
    return nullptr;
}

std::vector<RobotDescription> PluginLoader::kinds() const {
    std::vector<RobotDescription> kinds;
    for (const RobotDescription& robot : robots_) {
        const auto known = std::ranges::find(kinds, robot.class_name, &RobotDescription::class_name);
        if (known == kinds.end())
            kinds.push_back(robot);
        else
            known->behaviors.insert(known->behaviors.end(), robot.behaviors.begin(), robot.behaviors.end());
    }
    return kinds;
}

const BehaviorDescription* PluginLoader::behavior(const std::string& behavior_id) const {
    const RobotDescription* const robot = robotOf(behavior_id);
    return robot ? &*std::ranges::find(robot->behaviors, behavior_id, &BehaviorDescription::id) : nullptr;
}

} // namespace usar::agent
